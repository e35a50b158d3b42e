#include "apps/gnomon/scene_text.h"

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <variant>

#include "gnomon/errors.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const Point3& p) {
  return Json::array({p.x, p.y, p.z});
}

Json numbers(const Point2& p) {
  return Json::array({p.x, p.y});
}

template <class Points>
Json vertices(const Points& points) {
  Json list = Json::array();
  for (const auto& p : points) list.push_back(numbers(p));
  return list;
}

/// What the keys of a light are, beside its name.
struct LightKeys {
  double strength;

  Json operator()(const PointLight& light) const {
    return {{"shape", "point"}, {"position", numbers(light.position)}, {"intensity", strength}};
  }
  Json operator()(const DirectionalLight& light) const {
    return {{"shape", "direction"}, {"direction", numbers(light.direction)}, {"irradiance", strength}};
  }
  Json operator()(const LinearLight& light) const {
    return {{"shape", "segment"},
            {"vertices", Json::array({numbers(light.start), numbers(light.end)})},
            {"intensity_per_length", strength}};
  }
  Json operator()(const AreaLight& light) const {
    return {{"shape", "polygon"},
            {"vertices", vertices(light.polygon.points())},
            {"radiance", strength},
            {"two_sided", light.two_sided}};
  }
};

Json ring_vertices(const ConcavePolygon& polygon, std::size_t ring) {
  Json list = Json::array();
  for (const std::uint32_t i : polygon.rings[ring]) list.push_back(numbers(polygon.vertices[i]));
  return list;
}

struct BlockerKeys {
  Json operator()(const ConvexPolygon& polygon) const {
    return {{"shape", "polygon"}, {"vertices", vertices(polygon.points())}};
  }
  Json operator()(const Polytope& polytope) const {
    return {{"shape", "polytope"}, {"vertices", vertices(polytope.vertices)}};
  }
  Json operator()(const ConcavePolygon& polygon) const {
    if (polygon.rings.empty()) return {{"shape", polygon.shape}, {"vertices", vertices(polygon.vertices)}};
    Json json = {{"shape", polygon.shape}, {"vertices", ring_vertices(polygon, 0)}};
    for (std::size_t r = 1; r < polygon.rings.size(); ++r) json["holes"].push_back(ring_vertices(polygon, r));
    return json;
  }
  Json operator()(const Mesh&) const { throw PreconditionError("a mesh is a file of its own"); }
};

Json named(const std::string& name, const Json& keys) {
  Json element{{"name", name}};
  element.update(keys);
  return element;
}

Json planar_light(const PlanarLight& light) {
  if (light.vertices.size() == 1) {
    return {{"shape", "point"}, {"position", numbers(light.vertices.front())}, {"intensity", light.strength}};
  }
  return {{"shape", "segment"}, {"vertices", vertices(light.vertices)}, {"intensity_per_length", light.strength}};
}

Json planar_chain(const PlanarBlocker& chain) {
  return {{"shape", chain.vertices.size() == 2 ? "segment" : "polyline"}, {"vertices", vertices(chain.vertices)}};
}

}  // namespace

Json scene_document(const Scene& scene) {
  Json lights = Json::array(), blockers = Json::array(), receivers = Json::array();
  for (const SceneLight& light : scene.lights) {
    lights.push_back(named(light.name, std::visit(LightKeys{light.strength}, light.shape)));
  }
  for (const PlanarLight& light : scene.planar_lights) lights.push_back(named(light.name, planar_light(light)));
  for (const SceneBlocker& blocker : scene.blockers) {
    blockers.push_back(named(blocker.name, std::visit(BlockerKeys{}, blocker.shape)));
  }
  for (const PlanarBlocker& blocker : scene.planar_blockers) {
    blockers.push_back(named(blocker.name, planar_chain(blocker)));
  }
  for (const SceneReceiver& receiver : scene.receivers) {
    receivers.push_back(named(receiver.name, BlockerKeys{}(receiver.shape)));
  }
  for (const PlanarBlocker& receiver : scene.planar_receivers) {
    receivers.push_back(named(receiver.name, planar_chain(receiver)));
  }
  nlohmann::ordered_json document = {{"gnomon", 1}, {"dimension", scene.dimension}, {"length_unit", scene.length_unit}};
  if (scene.up == UpAxis::y) document["up"] = "y";
  document["lights"] = lights;
  document["blockers"] = blockers;
  document["receivers"] = receivers;
  return document;
}

}  // namespace gnomon
