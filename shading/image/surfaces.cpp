#include "shading/image/surfaces.h"

#include <map>
#include <utility>

#include "geometry/scene/receiver_facets.h"
#include "shading/exact_direction.h"
#include "shading/image/scene_radiance.h"
#include "shading/image/vertex_normals.h"

namespace gnomon::image {
namespace {

Point3 unit_normal(const ConvexPolygon& polygon) {
  ExactPolygon corners;
  for (const Point3& corner : polygon.points()) corners.push_back(exact(corner));
  const shading::Vector n = shading::direction_of(doubled_area(corners));
  const double size = shading::length(n);
  return {n.x / size, n.y / size, n.z / size};
}

Point3 of_unit_length(const Point3& n) {
  const shading::Vector v = shading::of_size_one({n.x, n.y, n.z});
  const double size = shading::length(v);
  return {v.x / size, v.y / size, v.z / size};
}

/// Where the parts of a scene's blockers are among its obstacles, by name.
std::map<std::string, std::uint32_t> part_numbers(const SpaceScene& scene) {
  std::map<std::string, std::uint32_t> numbers;
  for (const SceneBlocker& blocker : scene.blockers) {
    for (const ConvexPart& part : convex_parts(blocker)) {
      numbers.emplace(part.name, static_cast<std::uint32_t>(numbers.size()));
    }
  }
  return numbers;
}

/// The part that a facet bounds: `vase#12` or, if that is a solid, `vase`.
std::optional<std::uint32_t> part_of(const std::map<std::string, std::uint32_t>& parts, std::string facet) {
  for (;;) {
    if (const auto found = parts.find(facet); found != parts.end()) return found->second;
    const std::size_t end = facet.rfind('#');
    if (end == std::string::npos) return std::nullopt;
    facet.resize(end);
  }
}

class Builder {
 public:
  explicit Builder(const SpaceScene& scene) : scene_(scene), parts_(part_numbers(scene)) {}

  void add_blockers() {
    for (const SceneBlocker& blocker : scene_.blockers) {
      const std::vector<SceneReceiver> facets = receiver_facets(blocker.name, blocker.shape, ReceiverSides::front);
      begin(blocker.name);
      for (const SceneReceiver& facet : facets) {
        add(facet, material_named(scene_, blocker.material), part_of(parts_, facet.name));
      }
      result.flattened += add_vertex_normals(current(), blocker.smoothness);
    }
  }
  void add_receivers() {
    for (const ReceiverGroup group : receiver_elements(scene_.receivers)) {
      begin(group.front().element);
      for (const SceneReceiver& facet : group) {
        if (facet.side != group.front().side) break;
        add(facet, material_named(scene_, facet.material), std::nullopt);
      }
      result.flattened += add_vertex_normals(current(), group.front().smoothness);
    }
  }
  void add_lights() {
    result.lights_from = result.elements.size();
    for (const SceneLight& light : scene_.lights) {
      const auto* area = std::get_if<AreaLight>(&light.shape);
      if (!area) continue;
      begin(light.name);
      result.facets.push_back({area->polygon, unit_normal(area->polygon), {}, element(), 0, {}, nullptr, &light});
    }
  }

  Surfaces result;

 private:
  void begin(const std::string& name) {
    result.elements.push_back(name);
    first_ = result.facets.size();
  }
  std::uint32_t element() const { return static_cast<std::uint32_t>(result.elements.size() - 1); }
  std::span<Facet> current() { return std::span(result.facets).subspan(first_); }
  void add(const SceneReceiver& facet, const Material& material, std::optional<std::uint32_t> blocker) {
    const auto number = static_cast<std::uint32_t>(result.facets.size() - first_);
    std::vector<Point3> normals = facet.file_normals;
    for (Point3& n : normals) n = of_unit_length(n);
    result.facets.push_back(
        {facet.shape, unit_normal(facet.shape), std::move(normals), element(), number, blocker, &material, nullptr});
  }

  const SpaceScene& scene_;
  std::map<std::string, std::uint32_t> parts_;
  std::size_t first_ = 0;
};

}  // namespace

Surfaces surfaces_of(const SpaceScene& scene) {
  Builder builder(scene);
  builder.add_blockers();
  builder.add_receivers();
  builder.add_lights();
  return std::move(builder.result);
}

}  // namespace gnomon::image
