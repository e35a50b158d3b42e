#include "geometry/scene/polygon_refusal.h"

#include <CGAL/Polygon_2_algorithms.h>

#include <string_view>
#include <utility>
#include <vector>

#include "geometry/kernel.h"
#include "geometry/scene/json_node.h"
#include "geometry/spatial/convex_polygon.h"
#include "geometry/spatial/polygon_checks.h"

namespace gnomon {
namespace {

using FlatPoint = InputKernel::Point_2;
using FlatSegment = InputKernel::Segment_2;

PolygonRefusal too_few(std::size_t count) {
  return {{}, std::to_string(count) + (count == 1 ? " vertex" : " vertices"), "at least 3 vertices"};
}

PolygonRefusal repeated(std::span<const Point3> points, std::uint32_t vertex, std::uint32_t other) {
  return {vertex, "the point " + point_text(points[vertex]) + ", which repeats vertex " + std::to_string(other),
          "no repeated vertex"};
}

PolygonRefusal collinear() {
  return {{}, "vertices that all lie on one line", "a polygon with an area"};
}

PolygonRefusal not_coplanar(std::uint32_t vertex, double deviation) {
  return {vertex, "a vertex " + shortest(deviation) + " away from the polygon's plane",
          "coplanar vertices, or a deviation of at most 1e-9 of the polygon's diameter"};
}

std::vector<FlatPoint> projections(std::span<const Point3> points) {
  const int axis = polygon_plane(points)->dropped_axis;
  std::vector<FlatPoint> ring;
  for (const Point3& p : points) {
    const Point2 q = projected(p, axis);
    ring.emplace_back(q.x, q.y);
  }
  return ring;
}

/// Two edges that share more than they may. A search over all pairs, for messages only; short enough lists only.
std::string crossing_edges(const std::vector<FlatPoint>& ring) {
  const std::size_t n = ring.size();
  constexpr std::size_t longest = 2000;
  for (std::size_t j = 0; j < n && n <= longest; ++j) {
    const FlatSegment second(ring[j], ring[(j + 1) % n]);
    for (std::size_t i = 0; i < j; ++i) {
      const bool neighbours = i + 1 == j || (i == 0 && j + 1 == n);
      if (neighbours || !CGAL::do_intersect(FlatSegment(ring[i], ring[(i + 1) % n]), second)) continue;
      return "edges " + std::to_string(i) + " and " + std::to_string(j) + " meet";
    }
  }
  return "edges meet";
}

bool is_simple(const std::vector<FlatPoint>& ring) {
  return CGAL::is_simple_2(ring.begin(), ring.end(), InputKernel());
}

/// ` (edges 0 and 2 meet)`, or nothing if the boundary is simple.
std::string crossing_text(std::span<const Point3> points) {
  const std::vector<FlatPoint> ring = projections(points);
  return is_simple(ring) ? "" : " (" + crossing_edges(ring) + ")";
}

}  // namespace

std::optional<PolygonRefusal> convex_polygon_refusal(std::span<const Point3> points) {
  const std::optional<PolygonDefect> defect = ConvexPolygon::defect(points);
  if (!defect) return std::nullopt;
  constexpr std::string_view convex = "a convex polygon, its vertices in order around it";
  switch (defect->kind) {
    case PolygonDefect::Kind::too_few_vertices:
      return too_few(points.size());
    case PolygonDefect::Kind::repeated_vertex:
      return repeated(points, defect->vertex, defect->other);
    case PolygonDefect::Kind::collinear:
      return collinear();
    case PolygonDefect::Kind::not_coplanar:
      return not_coplanar(defect->vertex, defect->deviation);
    case PolygonDefect::Kind::not_convex:
      return PolygonRefusal{defect->vertex, "a boundary that turns the other way here" + crossing_text(points),
                            std::string(convex)};
    case PolygonDefect::Kind::self_crossing:
      break;
  }
  return PolygonRefusal{defect->vertex,
                        "a boundary that goes round more than once or runs back on itself" + crossing_text(points),
                        std::string(convex)};
}

std::optional<PolygonRefusal> simple_polygon_refusal(std::span<const Point3> points, double& deviation) {
  if (points.size() < 3) return too_few(points.size());
  if (const auto found = repeated_vertex(points)) return repeated(points, found->vertex, found->other);
  const std::optional<PolygonPlane> plane = polygon_plane(points);
  if (!plane) return collinear();
  deviation = plane->deviation;
  if (!plane->within_tolerance) return not_coplanar(plane->farthest, plane->deviation);
  if (points.size() == 3) return std::nullopt;
  const std::vector<FlatPoint> ring = projections(points);
  if (is_simple(ring)) return std::nullopt;
  return PolygonRefusal{{},
                        "a boundary that crosses or touches itself (" + crossing_edges(ring) + ")",
                        "a simple polygon, its vertices in order around it"};
}

std::string point_text(const Point3& point) {
  return "(" + shortest(point.x) + ", " + shortest(point.y) + ", " + shortest(point.z) + ")";
}

}  // namespace gnomon
