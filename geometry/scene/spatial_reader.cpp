#include "geometry/scene/spatial_reader.h"

#include <utility>

#include "geometry/scene/mesh_reader.h"
#include "geometry/scene/polygon_refusal.h"
#include "geometry/spatial/polygon_checks.h"

namespace gnomon {
namespace {

std::vector<Point3> points3(const VertexNodes& nodes) {
  std::vector<Point3> points;
  points.reserve(nodes.items.size());
  for (const JsonNode& item : nodes.items) points.push_back(point3(item));
  return points;
}

[[noreturn]] void refuse(const VertexNodes& nodes, const PolygonRefusal& refusal) {
  const JsonNode& node = refusal.vertex ? nodes.items[*refusal.vertex] : nodes.list;
  node.refuse(refusal.found, refusal.expected);
}

void doubt_rounding(const SceneElement& element, double deviation, Scene& scene) {
  if (deviation == 0) return;
  scene.doubts.push_back(element.title +
                         ": its vertices are not exactly coplanar; they deviate from a plane by up to " +
                         shortest(deviation) + " " + scene.length_unit +
                         ", within the limit of 1e-9 of its diameter, and count as rounded");
}

ConvexPolygon read_convex_polygon(const SceneElement& element, Scene& scene) {
  const VertexNodes nodes = vertex_nodes(element);
  std::vector<Point3> points = points3(nodes);
  if (const auto refusal = convex_polygon_refusal(points)) refuse(nodes, *refusal);
  ConvexPolygon polygon = ConvexPolygon::from_points(std::move(points));
  doubt_rounding(element, polygon.deviation(), scene);
  return polygon;
}

SceneLight read_area_light(const SceneElement& element, Scene& scene) {
  element.node.allow_keys({"name", "shape", "vertices", "radiance", "two_sided"}, "a polygon light");
  const double radiance = strength(element, "radiance");
  const auto two_sided = element.node.optional("two_sided");
  const bool both = two_sided && two_sided->boolean("true or false");
  return {element.name, AreaLight{read_convex_polygon(element, scene), both}, radiance};
}

SceneLight read_linear_light(const SceneElement& element) {
  element.node.allow_keys({"name", "shape", "vertices", "intensity_per_length"}, "a segment light");
  const VertexNodes nodes = vertex_nodes(element);
  const std::vector<Point3> points = points3(nodes);
  if (points.size() != 2) nodes.list.refuse_value("an array of 2 points");
  if (points[0] == points[1]) {
    nodes.items[1].refuse("the point " + point_text(points[1]) + ", which repeats vertex 0", "a segment with a length");
  }
  return {element.name, LinearLight{points[0], points[1]}, strength(element, "intensity_per_length")};
}

SceneLight read_point_light(const SceneElement& element) {
  element.node.allow_keys({"name", "shape", "position", "intensity"}, "a point light");
  const Point3 position = point3(element.node.required("position", "a point of 3 coordinates"));
  return {element.name, PointLight{position}, strength(element, "intensity")};
}

SceneLight read_directional_light(const SceneElement& element) {
  element.node.allow_keys({"name", "shape", "direction", "irradiance"}, "a direction light");
  const JsonNode node = element.node.required("direction", "a vector of 3 coordinates");
  const Point3 direction = point3(node);
  if (direction == Point3{}) node.refuse("the zero vector", "a direction");
  return {element.name, DirectionalLight{direction}, strength(element, "irradiance")};
}

Polytope read_polytope(const SceneElement& element) {
  const VertexNodes nodes = vertex_nodes(element);
  std::vector<Point3> points = points3(nodes);
  if (points.size() < 4) nodes.list.refuse_value("an array of at least 4 points");
  if (are_coplanar(points)) nodes.list.refuse("points that all lie in one plane", "points with a volume between them");
  return {std::move(points)};
}

ConcavePolygon read_concave_polygon(const SceneElement& element, Scene& scene) {
  const VertexNodes nodes = vertex_nodes(element);
  std::vector<Point3> points = points3(nodes);
  double deviation = 0;
  if (const auto refusal = simple_polygon_refusal(points, deviation)) refuse(nodes, *refusal);
  doubt_rounding(element, deviation, scene);
  return {std::move(points)};
}

BlockerShape read_blocker_shape(const SceneElement& element, const std::filesystem::path& folder, Scene& scene) {
  if (element.shape == "mesh") {
    element.node.allow_keys({"name", "shape", "file"}, "a mesh");
    return read_mesh(element, folder, scene);
  }
  if (element.shape != "polygon" && element.shape != "polytope" && element.shape != "concave_polygon") {
    refuse_shape(element, {"polygon", "polytope", "concave_polygon", "mesh"});
  }
  element.node.allow_keys({"name", "shape", "vertices"}, "a " + element.shape);
  if (element.shape == "polygon") return read_convex_polygon(element, scene);
  if (element.shape == "polytope") return read_polytope(element);
  return read_concave_polygon(element, scene);
}

}  // namespace

void read_spatial_lights(const std::vector<SceneElement>& elements, Scene& scene) {
  for (const SceneElement& element : elements) {
    if (element.shape == "polygon") {
      scene.lights.push_back(read_area_light(element, scene));
    } else if (element.shape == "segment") {
      scene.lights.push_back(read_linear_light(element));
    } else if (element.shape == "point") {
      scene.lights.push_back(read_point_light(element));
    } else if (element.shape == "direction") {
      scene.lights.push_back(read_directional_light(element));
    } else {
      refuse_shape(element, {"polygon", "segment", "point", "direction"});
    }
  }
}

void read_spatial_blockers(const std::vector<SceneElement>& elements, const std::filesystem::path& folder,
                           Scene& scene) {
  for (const SceneElement& element : elements) {
    scene.blockers.push_back({element.name, read_blocker_shape(element, folder, scene)});
  }
}

void read_spatial_receivers(const std::vector<SceneElement>& elements, Scene& scene) {
  for (const SceneElement& element : elements) {
    if (element.shape != "polygon") refuse_shape(element, {"polygon"});
    element.node.allow_keys({"name", "shape", "vertices"}, "a polygon receiver");
    scene.receivers.push_back({element.name, read_convex_polygon(element, scene)});
  }
}

}  // namespace gnomon
