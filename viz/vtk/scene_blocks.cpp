#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <variant>

#include "geometry/numbers/kernel.h"
#include "geometry/scene/convex_partition.h"
#include "geometry/scene/receiver_facets.h"
#include "geometry/scene/scene_points.h"
#include "gnomon/scene.h"
#include "viz/vtk/block.h"
#include "viz/vtk/cell_arrays.h"
#include "viz/vtk/vector.h"
#include "viz/vtk/vtk_cells.h"

namespace gnomon::viz {
namespace {

using Facets = std::vector<std::vector<std::uint32_t>>;

Facets one_polygon(std::size_t vertices) {
  Facets facets(1, std::vector<std::uint32_t>(vertices));
  std::iota(facets[0].begin(), facets[0].end(), 0u);
  return facets;
}

/// The triangles of the hull, outward, as numbers of the points given. Points inside the hull are in none of them.
Facets hull_facets(std::span<const Point3> vertices) {
  using Hull = CGAL::Polyhedron_3<InputKernel>;
  std::map<InputKernel::Point_3, std::uint32_t> numbers;
  std::vector<InputKernel::Point_3> points;
  for (const Point3& p : vertices) {
    points.push_back(to_cgal(p));
    numbers.emplace(points.back(), static_cast<std::uint32_t>(points.size() - 1));
  }
  Hull hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  Facets facets;
  for (auto facet = hull.facets_begin(); facet != hull.facets_end(); ++facet) {
    std::vector<std::uint32_t> corners;
    auto halfedge = facet->facet_begin();
    do {
      corners.push_back(numbers.at(halfedge->vertex()->point()));
    } while (++halfedge != facet->facet_begin());
    facets.push_back(std::move(corners));
  }
  return facets;
}

/// Polygons by facets, each in one piece or in several.
vtkSmartPointer<vtkPolyData> polygons(std::span<const Point3> points, const std::vector<Facets>& pieces,
                                      CellName cell) {
  vtkNew<vtkCellArray> cells;
  std::vector<CellName> names;
  for (std::size_t f = 0; f < pieces.size(); ++f) {
    cell.facet_id = static_cast<std::int32_t>(f);
    for (const auto& piece : pieces[f]) {
      insert_cell(*cells, piece);
      names.push_back(cell);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points));
  data->SetPolys(cells);
  add_cell_arrays(*data, names);
  return data;
}

vtkSmartPointer<vtkPolyData> polygons(std::span<const Point3> points, const Facets& facets, const CellName& cell) {
  std::vector<Facets> pieces;
  for (const auto& facet : facets) pieces.push_back({facet});
  return polygons(points, pieces, cell);
}

// ParaView measures and draws only triangles and convex cells rightly.
vtkSmartPointer<vtkPolyData> triangulated(vtkPolyData* data) {
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(data);
  filter->Update();
  auto triangles = vtkSmartPointer<vtkPolyData>::New();
  triangles->ShallowCopy(filter->GetOutput());
  return triangles;
}

vtkSmartPointer<vtkPolyData> points_or_line(std::span<const Point3> points, const CellName& cell) {
  vtkNew<vtkCellArray> cells;
  insert_cell(*cells, one_polygon(points.size())[0]);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points));
  points.size() == 1 ? data->SetVerts(cells) : data->SetLines(cells);
  add_cell_arrays(*data, std::vector<CellName>(1, cell));
  return data;
}

/// The smallest box around everything that has a place.
Box3 box_around(const SpaceScene& scene) {
  Box3 box{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  const auto add = [&box](std::span<const Point3> points) {
    for (const Point3& p : points) {
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
    }
  };
  for (const SceneLight& light : scene.lights) add(light_points(light.shape));
  for (const SceneBlocker& blocker : scene.blockers) add(blocker_points(blocker.shape));
  for (const SceneReceiver& receiver : scene.receivers) add(receiver.shape.points());
  return box.min.x <= box.max.x ? box : Box3{};
}

/// How far the way leads from the middle of a box to its border.
double distance_out(const Box3& box, const Point3& way) {
  const auto along = [](double side, double step) { return step == 0 ? HUGE_VAL : side / 2 / std::abs(step); };
  return std::min(
      {along(box.max.x - box.min.x, way.x), along(box.max.y - box.min.y, way.y), along(box.max.z - box.min.z, way.z)});
}

/// A directional light is drawn as a short arrow beside the scene, where the light comes from: shaft and four barbs.
vtkSmartPointer<vtkPolyData> arrow(const Point3& direction, const SpaceScene& scene, const CellName& cell) {
  const Box3 box = box_around(scene);
  const Point3 middle{std::midpoint(box.min.x, box.max.x), std::midpoint(box.min.y, box.max.y),
                      std::midpoint(box.min.z, box.max.z)};
  const double diagonal = length(box.max - box.min);
  const double size = diagonal > 0 && std::isfinite(diagonal) ? diagonal : 1;
  const Point3 way = unit(direction);
  const Point3 tip = middle - (distance_out(box, way) + 0.03 * size) * way;
  const Point3 aside = unit(cross(way, std::abs(way.z) < 0.9 ? Point3{0, 0, 1} : Point3{1, 0, 0}));
  const Point3 other = cross(way, aside);
  std::vector<Point3> points = {tip - 0.15 * size * way, tip};
  for (const Point3& side : {aside, -1 * aside, other, -1 * other}) {
    points.push_back(tip - 0.04 * size * way + 0.02 * size * side);
  }
  vtkNew<vtkCellArray> cells;
  insert_cell(*cells, std::vector<int>{0, 1});
  for (int barb = 2; barb < 6; ++barb) insert_cell(*cells, std::vector<int>{barb, 1});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(points));
  data->SetLines(cells);
  add_cell_arrays(*data, std::vector<CellName>(5, cell));
  return data;
}

struct LightData {
  CellName cell;
  const SpaceScene& scene;

  vtkSmartPointer<vtkPolyData> operator()(const PointLight& light) const {
    return points_or_line(std::vector{light.position}, cell);
  }
  vtkSmartPointer<vtkPolyData> operator()(const DirectionalLight& light) const {
    return arrow(light.direction, scene, cell);
  }
  vtkSmartPointer<vtkPolyData> operator()(const LinearLight& light) const {
    return points_or_line(std::vector{light.start, light.end}, cell);
  }
  vtkSmartPointer<vtkPolyData> operator()(const AreaLight& light) const {
    return polygons(light.polygon.points(), one_polygon(light.polygon.points().size()), cell);
  }
};

struct BlockerData {
  CellName cell;

  vtkSmartPointer<vtkPolyData> operator()(const ConvexPolygon& polygon) const {
    return polygons(polygon.points(), one_polygon(polygon.points().size()), cell);
  }
  vtkSmartPointer<vtkPolyData> operator()(const Polytope& polytope) const {
    return polygons(polytope.vertices, hull_facets(polytope.vertices), cell);
  }
  vtkSmartPointer<vtkPolyData> operator()(const ConcavePolygon& polygon) const {
    return triangulated(polygons(polygon.vertices, std::vector<Facets>{convex_pieces(polygon)}, cell));
  }
  vtkSmartPointer<vtkPolyData> operator()(const Mesh& mesh) const {
    std::vector<Facets> pieces;
    for (const auto& facet : mesh.facets) pieces.push_back(convex_pieces(mesh.vertices, facet));
    return triangulated(polygons(mesh.vertices, pieces, cell));
  }
};

std::string shape_name(const Light& light) {
  constexpr const char* names[] = {"point", "direction", "segment", "polygon"};
  return names[light.index()];
}

std::string shape_name(const BlockerShape& shape) {
  if (const auto* polygon = std::get_if<ConcavePolygon>(&shape)) return polygon->shape;
  constexpr const char* names[] = {"polygon", "polytope", "", "mesh"};
  return names[shape.index()];
}

Fields light_fields(const ShadowResult& result, const SceneLight& light) {
  Fields fields = element_fields(result, light.name, shape_name(light.shape));
  const auto* area = std::get_if<AreaLight>(&light.shape);
  fields.push_back({"strength", std::vector<double>{light.strength}});
  fields.push_back({"two_sided", std::vector<std::int32_t>{area != nullptr && area->two_sided ? 1 : 0}});
  return fields;
}

/// One block of all facets of a receiver, or of one side of it.
void append_receiver_block(std::vector<Block>& blocks, const ShadowResult& result, ReceiverGroup side) {
  std::vector<Point3> points;
  Facets facets;
  for (const SceneReceiver& facet : side) {
    Facets own = one_polygon(facet.shape.points().size());
    for (std::uint32_t& index : own[0]) index += static_cast<std::uint32_t>(points.size());
    facets.push_back(std::move(own[0]));
    points.insert(points.end(), facet.shape.points().begin(), facet.shape.points().end());
  }
  const std::string& name = side.front().side;
  append_block(blocks, {{"scene", "receivers", name},
                        side.size() == 1 ? "receiver" : "receiver_mesh",
                        element_fields(result, name, side.size() == 1 ? "polygon" : "mesh"),
                        polygons(points, facets, CellName{})});
}

}  // namespace

void append_scene_blocks(std::vector<Block>& blocks, const ShadowResult& result) {
  const auto& scene = std::get<SpaceScene>(*result.scene);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const SceneLight& light = scene.lights[i];
    CellName cell;
    cell.light_id = static_cast<std::int32_t>(i);
    append_block(blocks, {{"scene", "lights", light.name},
                          "light",
                          light_fields(result, light),
                          std::visit(LightData{cell, scene}, light.shape)});
  }
  for (std::size_t i = 0; i < scene.blockers.size(); ++i) {
    const SceneBlocker& blocker = scene.blockers[i];
    CellName cell;
    cell.blocker_id = static_cast<std::int32_t>(i);
    cell.facet_kind = static_cast<std::uint8_t>(FacetKind::blocker_face);
    append_block(blocks, {{"scene", "blockers", blocker.name},
                          "blocker",
                          element_fields(result, blocker.name, shape_name(blocker.shape)),
                          std::visit(BlockerData{cell}, blocker.shape)});
  }
  for (const ReceiverGroup side : receiver_sides(scene.receivers)) append_receiver_block(blocks, result, side);
}

}  // namespace gnomon::viz
