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
    Json json = {{"shape", "segment"},
                 {"vertices", Json::array({numbers(light.start), numbers(light.end)})},
                 {"intensity_per_length", strength}};
    const Emission& emission = light.emission;
    if (emission.exponent > 0) json["emission"] = {{"profile", "cosine"}, {"exponent", emission.exponent}};
    if (emission.flaps) json["flaps"] = {{"angle", *emission.flaps}};
    if (emission.shade) json["shade"] = {{"from", numbers(emission.shade->from)}, {"to", numbers(emission.shade->to)}};
    return json;
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

Json keys(const SceneLight& light) {
  return std::visit(LightKeys{light.strength}, light.shape);
}

Json keys(const SceneBlocker& blocker) {
  return std::visit(BlockerKeys{}, blocker.shape);
}

Json keys(const SceneReceiver& receiver) {
  return BlockerKeys{}(receiver.shape);
}

Json keys(const PlanarLight& light) {
  if (light.vertices.size() == 1) {
    return {{"shape", "point"}, {"position", numbers(light.vertices.front())}, {"intensity", light.strength}};
  }
  return {{"shape", "segment"}, {"vertices", vertices(light.vertices)}, {"intensity_per_length", light.strength}};
}

Json keys(const PlanarBlocker& chain) {
  return {{"shape", chain.vertices.size() == 2 ? "segment" : "polyline"}, {"vertices", vertices(chain.vertices)}};
}

template <class Element>
Json elements(const std::vector<Element>& list) {
  Json json = Json::array();
  for (const Element& element : list) {
    json.push_back(Json{{"name", element.name}});
    json.back().update(keys(element));
  }
  return json;
}

}  // namespace

Json scene_document(const Scene& scene) {
  const auto* space = std::get_if<SpaceScene>(&scene);
  nlohmann::ordered_json document = {
      {"gnomon", 1}, {"dimension", dimension(scene)}, {"length_unit", facts(scene).length_unit}};
  if (space && space->up == UpAxis::y) document["up"] = "y";
  const auto add_lists = [&](const auto& some) {
    document["lights"] = elements(some.lights);
    document["blockers"] = elements(some.blockers);
    document["receivers"] = elements(some.receivers);
  };
  std::visit(add_lists, scene);
  return document;
}

}  // namespace gnomon
