#include "geometry/scene/polygon_refusal.h"

#include "geometry/bodies/polygon_checks.h"
#include "geometry/scene/flat_ring.h"
#include "geometry/scene/json_node.h"

namespace gnomon {

PolygonRefusal too_few_refusal(std::size_t count) {
  return {{}, std::to_string(count) + (count == 1 ? " vertex" : " vertices"), "at least 3 vertices"};
}

PolygonRefusal repeated_refusal(std::span<const Point3> points, std::uint32_t vertex, std::uint32_t other) {
  return {vertex, "the point " + point_text(points[vertex]) + ", which repeats vertex " + std::to_string(other),
          "no repeated vertex"};
}

PolygonRefusal collinear_refusal() {
  return {{}, "vertices that all lie on one line", "a polygon with an area"};
}

PolygonRefusal convexity_refusal(std::span<const Point3> points, const PolygonDefect& defect) {
  const Ring all = whole_ring(points.size());
  const FlatRing ring = seen_along(polygon_plane(points)->dropped_axis, points, all);
  const std::string found = defect.kind == PolygonDefect::Kind::not_convex
                                ? "a boundary that turns the other way here"
                                : "a boundary that goes round more than once or runs back on itself";
  const std::string expected = "a convex polygon, its vertices in order around it";
  if (is_simple(ring)) return {defect.vertex, found, expected + ", or the shape \"concave_polygon\""};
  return {defect.vertex, found + " (" + crossing_edges(ring, all) + ")", expected};
}

std::string point_text(const Point3& point) {
  return "(" + shortest(point.x) + ", " + shortest(point.y) + ", " + shortest(point.z) + ")";
}

}  // namespace gnomon
