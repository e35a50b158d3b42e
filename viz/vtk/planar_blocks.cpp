#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <map>
#include <utility>

#include "gnomon/names.h"
#include "gnomon/shadow_volume.h"
#include "viz/vtk/block.h"
#include "viz/vtk/cell_arrays.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon::viz {
namespace {

using Corners = std::vector<std::uint32_t>;

/// Points of the plane at z = 0, each once, so that cells which meet share them.
class PointList {
 public:
  std::uint32_t number_of(const Point2& p) {
    const auto [place, is_new] = numbers_.try_emplace({p.x, p.y}, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back({p.x, p.y, 0});
    return place->second;
  }

  vtkSmartPointer<vtkPoints> points() const { return vtk_points(points_); }

 private:
  std::map<std::pair<double, double>, std::uint32_t> numbers_;
  std::vector<Point3> points_;
};

vtkSmartPointer<vtkPolyData> surface_data(const PointList& points) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points.points());
  return data;
}

CellName pair_cell(const PlanarPairResult& pair) {
  CellName cell;
  cell.light_id = static_cast<std::int32_t>(pair.light_id);
  cell.blocker_id = static_cast<std::int32_t>(pair.blocker_id);
  return cell;
}

CellName region_cell(const PlanarPairResult& pair, std::string_view region) {
  CellName cell = pair_cell(pair);
  if (region == "umbra") {
    cell.region = static_cast<std::uint8_t>(Region::umbra);
    cell.visible_fraction = 0;
  } else if (region == "penumbra") {
    cell.region = static_cast<std::uint8_t>(Region::penumbra);
  }
  return cell;
}

/// The corners of a polygon in order, without those that rounding has moved onto the one before.
Corners corners_of(const planar::NamedPolygon& polygon, PointList& points) {
  Corners corners;
  for (const Point2& p : polygon.vertices) corners.push_back(points.number_of(p));
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  return corners;
}

vtkSmartPointer<vtkPolyData> region_data(const planar::RegionInBox& region, CellName cell) {
  PointList points;
  vtkNew<vtkCellArray> polygons;
  std::vector<CellName> names;
  for (std::size_t i = 0; i < region.polygons.size(); ++i) {
    const Corners corners = corners_of(region.polygons[i], points);
    if (corners.size() < 3) continue;
    insert_cell(*polygons, corners);
    cell.facet_id = static_cast<std::int32_t>(i);
    names.push_back(cell);
  }
  auto data = surface_data(points);
  data->SetPolys(polygons);
  add_cell_arrays(*data, names);
  return data;
}

CellName line_cell(CellName cell, const planar::ExtremalLine& line, std::size_t facet_id) {
  const bool separating = line.contact == Contact::separating;
  cell.facet_id = static_cast<std::int32_t>(facet_id);
  cell.facet_kind =
      static_cast<std::uint8_t>(separating ? FacetKind::separating_blocker_plane : FacetKind::supporting_blocker_plane);
  cell.edge_index = static_cast<std::int32_t>(number(line.blocker_end));
  cell.vertex_index = static_cast<std::int32_t>(number(line.light_end));
  return cell;
}

vtkSmartPointer<vtkPolyData> line_data(const std::vector<planar::LineInBox>& lines, const CellName& cell) {
  PointList points;
  vtkNew<vtkCellArray> cells;
  std::vector<CellName> names;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    insert_cell(*cells, Corners{points.number_of(lines[i].start), points.number_of(lines[i].end)});
    names.push_back(line_cell(cell, lines[i].name, i));
  }
  auto data = surface_data(points);
  data->SetLines(cells);
  add_cell_arrays(*data, names);
  return data;
}

/// One point, or one line per segment.
vtkSmartPointer<vtkPolyData> element_data(const std::vector<Point2>& vertices, CellName cell) {
  PointList points;
  vtkNew<vtkCellArray> cells;
  std::vector<CellName> names;
  const bool is_point = vertices.size() == 1;
  for (std::size_t i = 0; i < (is_point ? 1 : vertices.size() - 1); ++i) {
    Corners corners{points.number_of(vertices[i])};
    if (!is_point) corners.push_back(points.number_of(vertices[i + 1]));
    insert_cell(*cells, corners);
    cell.facet_id = static_cast<std::int32_t>(i);
    names.push_back(cell);
  }
  auto data = surface_data(points);
  is_point ? data->SetVerts(cells) : data->SetLines(cells);
  add_cell_arrays(*data, names);
  return data;
}

std::string shape_name(const std::vector<Point2>& vertices) {
  if (vertices.size() == 1) return "point";
  return vertices.size() == 2 ? "segment" : "polyline";
}

void append_lights(std::vector<Block>& blocks, const ShadowResult& result) {
  CellName cell;
  for (const PlanarLight& light : std::get<PlaneScene>(*result.scene).lights) {
    ++cell.light_id;
    Fields fields = element_fields(result, light.name, shape_name(light.vertices));
    fields.push_back({"strength", std::vector<double>{light.strength}});
    append_block(blocks,
                 {{"scene", "lights", light.name}, "light", std::move(fields), element_data(light.vertices, cell)});
  }
}

void append_elements(std::vector<Block>& blocks, const ShadowResult& result) {
  const auto& scene = std::get<PlaneScene>(*result.scene);
  const auto append = [&](const std::string& list, const std::string& kind, const PlanarBlocker& element,
                          const CellName& cell) {
    append_block(blocks, {{"scene", list, element.name},
                          kind,
                          element_fields(result, element.name, shape_name(element.vertices)),
                          element_data(element.vertices, cell)});
  };
  CellName cell;
  cell.facet_kind = static_cast<std::uint8_t>(FacetKind::blocker_face);
  for (const PlanarBlocker& blocker : scene.blockers) {
    ++cell.blocker_id;
    append("blockers", "blocker", blocker, cell);
  }
  for (const PlanarBlocker& receiver : scene.receivers) {
    append("receivers", "receiver", receiver, CellName{});
  }
}

void append_regions(std::vector<Block>& blocks, const ShadowResult& result, const PlanarPairResult& pair) {
  const auto append = [&](const std::string& name, const planar::RegionInBox& region) {
    Fields fields = pair_fields(result, pair.light, pair.blocker, region.truncated);
    fields.push_back({"volume_total", std::vector<double>{region.area.nearest}});
    fields.push_back({"volume_exact", std::vector<std::string>{region.area.exact}});
    append_block(blocks, {{"volumes", pair.light, pair.blocker, name},
                          "volume",
                          std::move(fields),
                          region_data(region, region_cell(pair, name))});
  };
  append("occlusion", pair.in_box.occlusion);
  append("umbra", pair.in_box.umbra);
  append("penumbra", pair.in_box.penumbra);
}

void append_lines(std::vector<Block>& blocks, const ShadowResult& result, const PlanarPairResult& pair) {
  append_block(blocks, {{"extremal_planes", pair.light, pair.blocker},
                        "extremal_planes",
                        pair_fields(result, pair.light, pair.blocker, true),
                        line_data(pair.in_box.lines, pair_cell(pair))});
}

}  // namespace

std::vector<Block> planar_shadow_blocks(const ShadowResult& result) {
  std::vector<const PlanarPairResult*> pairs;
  for (const PlanarPairResult& pair : result.planar_pairs) pairs.push_back(&pair);
  std::ranges::stable_sort(pairs, {}, &PlanarPairResult::light_id);

  std::vector<Block> blocks;
  append_lights(blocks, result);
  append_elements(blocks, result);
  for (const auto append : {append_regions, append_lines}) {
    for (const PlanarPairResult* pair : pairs) append(blocks, result, *pair);
  }
  append_partition_blocks(blocks, result);
  return blocks;
}

}  // namespace gnomon::viz
