#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <utility>

#include "gnomon/names.h"
#include "gnomon/shadow_volume.h"
#include "viz/vtk/block.h"
#include "viz/vtk/cell_arrays.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon::viz {
namespace {

using planar::BoundaryKind;
using planar::BoundaryName;
using planar::EventPoint;
using planar::EventPointKind;

vtkSmartPointer<vtkPolyData> point_data(const planar::PartitionInBox& in_box) {
  std::vector<Point3> points;
  for (const Point2& p : in_box.points) points.push_back({p.x, p.y, 0});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points));
  return data;
}

/// True if rounding has left a triangle its three corners.
bool has_corners(const planar::PartitionInBox& in_box, const planar::FaceTriangle& triangle) {
  const auto corner = [&](std::size_t k) { return in_box.points[triangle.corners[k]]; };
  return corner(0) != corner(1) && corner(1) != corner(2) && corner(2) != corner(0);
}

vtkSmartPointer<vtkPolyData> region_data(const PlanarLightResult& light, Region region) {
  auto data = point_data(light.in_box);
  vtkNew<vtkCellArray> triangles;
  std::vector<CellName> names;
  CellName cell;
  cell.region = static_cast<std::uint8_t>(region);
  cell.light_id = static_cast<std::int32_t>(light.light_id);
  if (region == Region::lit) cell.visible_fraction = 1;
  if (region == Region::umbra) cell.visible_fraction = 0;
  for (const planar::FaceTriangle& triangle : light.in_box.triangles) {
    if (light.in_box.faces[triangle.face].region != region || !has_corners(light.in_box, triangle)) continue;
    insert_cell(*triangles, triangle.corners);
    cell.facet_id = static_cast<std::int32_t>(triangle.face);
    names.push_back(cell);
  }
  data->SetPolys(triangles);
  add_cell_arrays(*data, names);
  return data;
}

std::string point_name(const PlanarLightResult& light, const EventPoint& point) {
  switch (point.kind) {
    case EventPointKind::light_end:
      return light.light + " end " + std::to_string(point.end);
    case EventPointKind::blocker_end:
      return light.blockers[point.element] + " end " + std::to_string(point.end);
    case EventPointKind::crossing:
      return light.blockers[point.element] + " crossing " + light.light;
    case EventPointKind::viewpoint:
      break;
  }
  return {};
}

std::string boundary_name(const PlanarLightResult& light, const BoundaryName& name) {
  switch (name.kind) {
    case BoundaryKind::blocker:
      return light.blockers[name.element];
    case BoundaryKind::light_line:
      return "line of " + light.light;
    case BoundaryKind::clip_box:
      return "clip box";
    case BoundaryKind::event:
      break;
  }
  return std::string(gnomon::name(name.contact)) + ": " + point_name(light, name.near) + ", " +
         point_name(light, name.far);
}

std::uint8_t facet_kind(const BoundaryName& name) {
  switch (name.kind) {
    case BoundaryKind::blocker:
      return static_cast<std::uint8_t>(FacetKind::blocker_face);
    case BoundaryKind::light_line:
      return static_cast<std::uint8_t>(FacetKind::light_plane);
    case BoundaryKind::clip_box:
      return static_cast<std::uint8_t>(FacetKind::clip_box);
    case BoundaryKind::event:
      break;
  }
  return static_cast<std::uint8_t>(name.contact == Contact::separating ? FacetKind::separating_blocker_plane
                                                                       : FacetKind::supporting_blocker_plane);
}

CellName boundary_cell(const PlanarLightResult& light, const BoundaryName& name) {
  CellName cell;
  cell.light_id = static_cast<std::int32_t>(light.light_id);
  cell.facet_kind = facet_kind(name);
  if (name.kind == BoundaryKind::blocker) cell.blocker_id = static_cast<std::int32_t>(light.blocker_ids[name.element]);
  if (name.kind == BoundaryKind::clip_box) cell.edge_index = static_cast<std::int32_t>(name.element);
  if (name.kind != BoundaryKind::event) return cell;
  cell.blocker_id = static_cast<std::int32_t>(light.blocker_ids[name.far.element]);
  cell.edge_index = static_cast<std::int32_t>(name.far.end);
  if (name.near.kind == EventPointKind::light_end) cell.vertex_index = static_cast<std::int32_t>(name.near.end);
  return cell;
}

vtkSmartPointer<vtkPolyData> boundary_data(const PlanarLightResult& light) {
  auto data = point_data(light.in_box);
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkStringArray> events;
  events->SetName("boundary");
  std::vector<CellName> names;
  for (const planar::PartitionEdge& edge : light.partition.edges()) {
    const BoundaryName& name = light.partition.names()[edge.name];
    if (light.in_box.points[edge.source] == light.in_box.points[edge.target]) continue;
    insert_cell(*lines, std::array{edge.source, edge.target});
    names.push_back(boundary_cell(light, name));
    names.back().facet_id = static_cast<std::int32_t>(names.size()) - 1;
    events->InsertNextValue(boundary_name(light, name));
  }
  data->SetLines(lines);
  add_cell_arrays(*data, names);
  data->GetCellData()->AddArray(events);
  return data;
}

}  // namespace

void append_partition_blocks(std::vector<Block>& blocks, const ShadowResult& result) {
  for (const PlanarLightResult& light : result.planar_lights) {
    for (const Region region : {Region::lit, Region::penumbra, Region::umbra}) {
      const ExactNumber& area = light.in_box.area(region);
      Fields fields = leaf_fields(result, true);
      fields.push_back({"light", std::vector<std::string>{light.light}});
      fields.push_back({"volume_total", std::vector<double>{area.nearest}});
      fields.push_back({"volume_exact", std::vector<std::string>{area.exact}});
      append_block(blocks, {{"regions", light.light, std::string(name(region))},
                            "region",
                            std::move(fields),
                            region_data(light, region)});
    }
    append_block(blocks, {{"boundaries", light.light}, "boundaries", leaf_fields(result, true), boundary_data(light)});
  }
}

}  // namespace gnomon::viz
