#include "apps/proof/laws/enumeration.h"

#include <algorithm>
#include <optional>

#include "apps/proof/laws/definition.h"

namespace gnomon::laws {
namespace {

using Polygon = std::vector<ExactVector>;

/// The contacts of a plane with the pair, one bit each; it has none if it crosses the light or the blocker.
struct Contacts {
  bool separating = false;
  bool supporting = false;
};

Contacts contacts(const ExactPlane& plane, const Polygon& light, const Polygon& blocker) {
  if (is_zero(plane.normal)) return {};
  const std::optional<int> light_side = common_side(plane, light);
  const std::optional<int> blocker_side = common_side(plane, blocker);
  if (!light_side || !blocker_side) return {};
  return {*light_side * *blocker_side <= 0, *light_side * *blocker_side >= 0};
}

/// True if the plane holds two of the points.
bool holds_an_edge(const ExactPlane& plane, const Polygon& points) {
  return std::ranges::count_if(points, [&](const ExactVector& p) { return plane.side(p) == 0; }) >= 2;
}

void name_blocker_planes(const Polygon& light, const Polygon& blocker, ExtremalPlanes& planes) {
  for (const PolygonSide& side : sides(blocker)) {
    std::optional<LightVertex> separating;
    std::optional<LightVertex> supporting;
    for (std::uint32_t v = 0; v < light.size(); ++v) {
      const Contacts found = contacts(plane_through(side.from, side.to, light[v]), light, blocker);
      if (found.separating && !separating) separating = LightVertex{v};
      if (found.supporting && !supporting) supporting = LightVertex{v};
    }
    planes.separating_blocker.push_back({BlockerEdge{side.lowest_edge}, separating.value()});
    planes.supporting_blocker.push_back({BlockerEdge{side.lowest_edge}, supporting.value()});
  }
}

/// The light's straight sides: those of an area light, one for a linear light, none for a point.
std::vector<PolygonSide> light_sides(const Polygon& light) {
  if (light.size() < 2) return {};
  if (light.size() == 2) return {{light[0], light[1], 0}};
  return sides(light);
}

void name_light_planes(const Polygon& light, const Polygon& blocker, ExtremalPlanes& planes) {
  for (const PolygonSide& side : light_sides(light)) {
    for (std::uint32_t v = 0; v < blocker.size(); ++v) {
      const ExactPlane plane = plane_through(side.from, side.to, blocker[v]);
      if (!contacts(plane, light, blocker).separating || holds_an_edge(plane, blocker)) continue;
      planes.separating_light.push_back({LightEdge{side.lowest_edge}, BlockerVertex{v}});
    }
  }
}

bool line_meets(const Polygon& segment, const Polygon& blocker) {
  const ExactPlane plane = plane_of(blocker);
  const Rational from = plane.height(segment[0]);
  const Rational to = plane.height(segment[1]);
  if (from == to) return false;
  const ExactVector foot = segment[0] + Rational(from / (from - to)) * (segment[1] - segment[0]);
  for (std::size_t i = 0; i < blocker.size(); ++i) {
    const ExactVector edge = blocker[(i + 1) % blocker.size()] - blocker[i];
    if (sign(dot(cross(edge, foot - blocker[i]), plane.normal)) < 0) return false;
  }
  return true;
}

/// Planes that hold a side of the light, a side of the blocker, and separate the two.
std::size_t coplanar_pairs(const Polygon& light, const Polygon& blocker) {
  std::size_t pairs = 0;
  for (const PolygonSide& a : light_sides(light)) {
    for (const PolygonSide& b : sides(blocker)) {
      const ExactPlane plane = plane_through(b.from, b.to, a.from);
      pairs += plane.side(a.to) == 0 && contacts(plane, light, blocker).separating;
    }
  }
  return pairs;
}

}  // namespace

std::vector<PolygonSide> sides(const Polygon& polygon) {
  const std::size_t size = polygon.size();
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < size; ++i) {
    const ExactVector in = polygon[i] - polygon[(i + size - 1) % size];
    const ExactVector out = polygon[(i + 1) % size] - polygon[i];
    if (!is_zero(cross(in, out))) corners.push_back(i);
  }
  std::vector<PolygonSide> result;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t from = corners[k];
    const std::size_t to = corners[(k + 1) % corners.size()];
    // The side that runs past the last vertex holds edge 0 if vertex 0 is no corner.
    const std::size_t lowest = to < from && to != 0 ? 0 : from;
    result.push_back({polygon[from], polygon[to], static_cast<std::uint32_t>(lowest)});
  }
  return result;
}

ExtremalPlanes enumerated_planes(const Light& light, const ConvexPolygon& blocker) {
  ExtremalPlanes planes;
  name_blocker_planes(vertices(light), exact(blocker.points()), planes);
  name_light_planes(vertices(light), exact(blocker.points()), planes);
  return planes;
}

PlaneCounts plane_counts(const Light& light, const ConvexPolygon& blocker) {
  const Polygon emitter = vertices(light);
  const Polygon hindrance = exact(blocker.points());
  PlaneCounts counts;
  counts.blocker_sides = sides(hindrance).size();
  if (emitter.size() == 2 && line_meets(emitter, hindrance)) return counts;
  counts.light_sides = emitter.size() == 2 ? 2 : light_sides(emitter).size();
  counts.coplanar_pairs = coplanar_pairs(emitter, hindrance);
  return counts;
}

}  // namespace gnomon::laws
