#include "geometry/discontinuity/light_before.h"

#include <algorithm>

namespace gnomon::event {
namespace {

/// Where an edge of the light passes through the plane.
ExactVector passage(const EventScene& scene, const LightEdge& edge, const ReceiverPlane& plane) {
  const ExactVector p = exact(scene.points[edge.a].input), q = exact(scene.points[edge.b].input);
  const Rational at_p = plane.plane().height(p), at_q = plane.plane().height(q);
  return p + Rational(at_p / (at_p - at_q)) * (q - p);
}

/// An edge of the light at a vertex, if one rises from the plane such a one.
EventElement rising_edge(const EventScene& scene, const LightBefore& light, std::size_t vertex) {
  const std::size_t n = light.sides.size();
  if (scene.light_edges.empty()) return scene.light_vertices[vertex].name;
  if (n == 2 || light.sides[(vertex + 1) % n] <= 0) return scene.light_edges[n == 2 ? 0 : (vertex + n - 1) % n].name;
  return scene.light_edges[vertex].name;
}

}  // namespace

bool LightBefore::is_whole() const {
  return std::all_of(sides.begin(), sides.end(), [](int s) { return s > 0; });
}

LightBefore light_before(const EventScene& scene, const Shape& receiver, const ReceiverPlane& plane) {
  LightBefore light;
  const auto& c = receiver.plane;
  for (const LightVertex& v : scene.light_vertices) {
    light.sides.push_back(
        orientation(scene.points[c[0]], scene.points[c[1]], scene.points[c[2]], scene.points[v.point]));
  }
  if (std::none_of(light.sides.begin(), light.sides.end(), [](int s) { return s > 0; })) return light;
  const std::size_t n = light.sides.size();
  for (std::size_t k = 0; k < n; ++k) {
    const LightVertex& v = scene.light_vertices[k];
    if (light.sides[k] >= 0) {
      light.corners.push_back({exact(scene.points[v.point].input), light.sides[k], rising_edge(scene, light, k)});
    }
    if (k >= scene.light_edges.size() || light.sides[k] * light.sides[(k + 1) % n] >= 0) continue;
    const LightEdge& edge = scene.light_edges[k];
    light.corners.push_back({passage(scene, edge, plane), 0, edge.name});
  }
  return light;
}

}  // namespace gnomon::event
