#include "geometry/scene/spatial_reader.h"

#include <algorithm>
#include <utility>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/orientation.h"
#include "geometry/scene/camera_reader.h"
#include "geometry/scene/emission_reader.h"
#include "geometry/scene/mesh_reader.h"
#include "geometry/scene/polygon_reader.h"
#include "geometry/scene/polygon_refusal.h"
#include "geometry/scene/receiver_facets.h"
#include "geometry/scene/surface_reader.h"

namespace gnomon {
namespace {

std::vector<Point3> points3(const VertexNodes& nodes) {
  std::vector<Point3> points;
  points.reserve(nodes.items.size());
  for (const JsonNode& item : nodes.items) points.push_back(point3(item));
  return points;
}

bool is_polygon(const SceneElement& element) {
  return element.shape == "polygon" || element.shape == "concave_polygon";
}

ConcaveRing concave_ring(const SceneElement& element) {
  return element.shape == "polygon" ? ConcaveRing::refused : ConcaveRing::accepted;
}

bool is_two_sided(const SceneElement& element) {
  const auto node = element.node.optional("two_sided");
  return node && node->boolean("true or false");
}

void read_area_light(const SceneElement& element, SpaceScene& scene) {
  element.node.allow_keys({"name", "shape", "vertices", "holes", "radiance", "two_sided", "color"}, "a polygon light");
  const double radiance = strength(element, "radiance");
  const bool both = is_two_sided(element);
  for (NamedPolygon& part : polygon_parts(element.name, read_polygon(element, ConcaveRing::of_light, scene))) {
    scene.lights.push_back({std::move(part.name), AreaLight{std::move(part.polygon), both}, radiance,
                            light_colour(element), element.name, element.shape});
  }
}

/// Turns facets that run inward, as seen by some vertex off the first facet's plane.
///
/// Requires: a closed convex mesh.
void turn_outward(Mesh& mesh, const std::string& title, std::vector<std::string>& doubts) {
  for (const std::vector<std::uint32_t>& facet : mesh.facets) {
    for (const Point3& p : mesh.vertices) {
      const int side = exact_orientation(mesh.vertices[facet[0]], mesh.vertices[facet[1]], mesh.vertices[facet[2]], p);
      if (side < 0) return;
      if (side == 0) continue;
      for (std::vector<std::uint32_t>& turned : mesh.facets) std::ranges::reverse(turned);
      doubts.push_back(title + ": its facets run inward; it shines outward all the same");
      return;
    }
  }
}

/// A solid that shines from every facet.
void read_mesh_light(const SceneElement& element, const std::filesystem::path& folder, SpaceScene& scene) {
  element.node.allow_keys({"name", "shape", "file", "vertices", "facets", "radiance", "color"}, "a mesh light");
  const double radiance = strength(element, "radiance");
  Mesh mesh = read_mesh(element, folder, scene, MeshUse::light);
  turn_outward(mesh, element.title, scene.doubts);
  for (SceneReceiver& facet : receiver_facets(element.name, std::move(mesh), ReceiverSides::front)) {
    scene.lights.push_back({std::move(facet.name), AreaLight{std::move(facet.shape)}, radiance, light_colour(element),
                            element.name, element.shape});
  }
}

SceneLight read_linear_light(const SceneElement& element) {
  element.node.allow_keys({"name", "shape", "vertices", "intensity_per_length", "color", "emission", "flaps", "shade"},
                          "a segment light");
  const VertexNodes nodes = vertex_nodes(element);
  const std::vector<Point3> points = points3(nodes);
  if (points.size() != 2) nodes.list.refuse_value("an array of 2 points");
  if (points[0] == points[1]) {
    nodes.items[1].refuse("the point " + point_text(points[1]) + ", which repeats vertex 0", "a segment with a length");
  }
  return {element.name, LinearLight{points[0], points[1], read_emission(element, points[0], points[1])},
          strength(element, "intensity_per_length"), light_colour(element)};
}

SceneLight read_point_light(const SceneElement& element) {
  element.node.allow_keys({"name", "shape", "position", "intensity", "color"}, "a point light");
  const Point3 position = point3(element.node.required("position", "a point of 3 coordinates"));
  return {element.name, PointLight{position}, strength(element, "intensity"), light_colour(element)};
}

SceneLight read_directional_light(const SceneElement& element) {
  element.node.allow_keys({"name", "shape", "direction", "irradiance", "color"}, "a direction light");
  const JsonNode node = element.node.required("direction", "a vector of 3 coordinates");
  const Point3 direction = point3(node);
  if (direction == Point3{}) node.refuse("the zero vector", "a direction");
  return {element.name, DirectionalLight{direction}, strength(element, "irradiance"), light_colour(element)};
}

Polytope read_polytope(const SceneElement& element) {
  const VertexNodes nodes = vertex_nodes(element);
  std::vector<Point3> points = points3(nodes);
  if (points.size() < 4) nodes.list.refuse_value("an array of at least 4 points");
  if (are_coplanar(points)) nodes.list.refuse("points that all lie in one plane", "points with a volume between them");
  return {std::move(points)};
}

void allow_shape_keys(const SceneElement& element, std::initializer_list<std::string_view> keys, MeshUse use) {
  std::vector<std::string_view> all = {"name", "shape", "material"};
  all.insert(all.end(), keys);
  if (use == MeshUse::receiver) all.push_back("two_sided");
  element.node.allow_keys(all, "a " + element.shape + (use == MeshUse::receiver ? " receiver" : ""));
}

BlockerShape read_shape(const SceneElement& element, MeshUse use, const std::filesystem::path& folder,
                        SpaceScene& scene) {
  if (element.shape == "mesh") {
    allow_shape_keys(element, {"file", "vertices", "facets", "usemtl", "normals", "crease"}, use);
    return read_mesh(element, folder, scene, use);
  }
  if (element.shape == "polytope") {
    allow_shape_keys(element, {"vertices"}, use);
    return read_polytope(element);
  }
  if (!is_polygon(element)) refuse_shape(element, {"polygon", "polytope", "concave_polygon", "mesh"});
  allow_shape_keys(element, {"vertices", "holes"}, use);
  return std::visit([](auto polygon) { return BlockerShape(std::move(polygon)); },
                    read_polygon(element, concave_ring(element), scene));
}

}  // namespace

void read_spatial_lights(const std::vector<SceneElement>& elements, const std::filesystem::path& folder,
                         SpaceScene& scene) {
  for (const SceneElement& element : elements) {
    if (is_polygon(element)) {
      read_area_light(element, scene);
    } else if (element.shape == "segment") {
      scene.lights.push_back(read_linear_light(element));
    } else if (element.shape == "point") {
      scene.lights.push_back(read_point_light(element));
    } else if (element.shape == "direction") {
      scene.lights.push_back(read_directional_light(element));
    } else if (element.shape == "mesh") {
      read_mesh_light(element, folder, scene);
    } else {
      refuse_shape(element, {"polygon", "concave_polygon", "mesh", "segment", "point", "direction"});
    }
  }
}

void read_spatial_blockers(const std::vector<SceneElement>& elements, const std::filesystem::path& folder,
                           SpaceScene& scene) {
  for (const SceneElement& element : elements) {
    scene.blockers.push_back({element.name, read_shape(element, MeshUse::blocker, folder, scene),
                              material_name(element, scene), read_smoothness(element)});
  }
}

void read_spatial_receivers(const std::vector<SceneElement>& elements, const std::filesystem::path& folder,
                            SpaceScene& scene) {
  for (const SceneElement& element : elements) {
    const ReceiverSides sides = is_two_sided(element) ? ReceiverSides::both : ReceiverSides::front;
    const BlockerShape shape = read_shape(element, MeshUse::receiver, folder, scene);
    for (SceneReceiver& facet : receiver_facets(element.name, shape, sides)) {
      facet.form = element.shape;
      facet.material = material_name(element, scene);
      facet.smoothness = read_smoothness(element);
      scene.receivers.push_back(std::move(facet));
    }
  }
}

}  // namespace gnomon
