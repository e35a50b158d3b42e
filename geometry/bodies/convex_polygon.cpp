#include "gnomon/convex_polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/kernel.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

using Kind = PolygonDefect::Kind;
using FlatPoint = InputKernel::Point_2;

/// What the checks find out on the way.
struct Examination {
  std::optional<PolygonDefect> defect;
  std::vector<int> turns;  ///< at each vertex, seen along the dominant axis: sign of the orientation
  double deviation = 0;
};

void require_finite(std::span<const Point3> points) {
  const auto finite = [](const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  if (!std::all_of(points.begin(), points.end(), finite)) throw PreconditionError("a coordinate is not finite");
}

std::vector<FlatPoint> projections(std::span<const Point3> points, int dropped_axis) {
  std::vector<FlatPoint> result;
  result.reserve(points.size());
  for (const Point3& p : points) {
    const Point2 q = projected(p, dropped_axis);
    result.emplace_back(q.x, q.y);
  }
  return result;
}

std::vector<int> turn_signs(const std::vector<FlatPoint>& ring) {
  std::vector<int> signs(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const FlatPoint& before = ring[i == 0 ? ring.size() - 1 : i - 1];
    const FlatPoint& after = ring[i + 1 == ring.size() ? 0 : i + 1];
    signs[i] = static_cast<int>(CGAL::orientation(before, ring[i], after));
  }
  return signs;
}

/// +1 where the edge from vertex i to i + 1 runs lexicographically upwards, -1 downwards, 0 if it has no length.
std::vector<int> edge_directions(const std::vector<FlatPoint>& ring) {
  std::vector<int> directions(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    directions[i] = static_cast<int>(CGAL::compare_xy(ring[i + 1 == ring.size() ? 0 : i + 1], ring[i]));
  }
  return directions;
}

/// A closed chain that never turns back goes round as often as it changes its lexicographic direction, halved: each
/// full turn passes the two changes once, and a reversal counts as half a turn. So two changes mean a convex boundary.
std::optional<PolygonDefect> boundary_defect(const std::vector<FlatPoint>& ring, const std::vector<int>& turns) {
  const auto lowest = std::min_element(ring.begin(), ring.end()) - ring.begin();
  const int forward = turns[static_cast<std::size_t>(lowest)];
  // The lowest vertex of a polygon lies between two edges that leave it upwards: straight means folded back.
  if (forward == 0) return PolygonDefect{Kind::self_crossing, static_cast<std::uint32_t>(lowest)};
  const auto wrong = std::find(turns.begin(), turns.end(), -forward);
  if (wrong != turns.end()) {
    return PolygonDefect{Kind::not_convex, static_cast<std::uint32_t>(wrong - turns.begin())};
  }
  const std::vector<int> directions = edge_directions(ring);
  int changes = 0;
  for (std::uint32_t i = 0; i < directions.size(); ++i) {
    if (directions[i] != directions[i == 0 ? directions.size() - 1 : i - 1]) ++changes;
    // Vertices of a rounded polygon may differ across its plane alone; such an edge has no direction.
    if (changes > 2 || directions[i] == 0) return PolygonDefect{Kind::self_crossing, i};
  }
  return std::nullopt;
}

Examination examine(std::span<const Point3> points) {
  require_finite(points);
  if (points.size() < 3) return {PolygonDefect{Kind::too_few_vertices}, {}};
  if (const auto repeated = repeated_vertex(points)) {
    return {PolygonDefect{Kind::repeated_vertex, repeated->vertex, repeated->other}, {}};
  }
  const std::optional<PolygonPlane> plane = polygon_plane(points);
  if (!plane) return {PolygonDefect{Kind::collinear}, {}};
  if (plane->flatness > Flatness::rounded) {
    return {PolygonDefect{Kind::not_coplanar, plane->farthest, 0, plane->deviation}, {}};
  }
  const std::vector<FlatPoint> ring = projections(points, plane->dropped_axis);
  std::vector<int> turns = turn_signs(ring);
  std::optional<PolygonDefect> defect = boundary_defect(ring, turns);
  return {defect, std::move(turns), plane->deviation};
}

}  // namespace

std::optional<PolygonDefect> ConvexPolygon::defect(std::span<const Point3> points) {
  return examine(points).defect;
}

ConvexPolygon ConvexPolygon::from_points(std::vector<Point3> points) {
  const Examination examination = examine(points);
  if (examination.defect) throw PreconditionError("the points are not the vertices of a convex polygon");
  ConvexPolygon polygon;
  polygon.points_ = std::move(points);
  polygon.deviation_ = examination.deviation;
  for (std::uint32_t i = 0; i < examination.turns.size(); ++i) {
    if (examination.turns[i] != 0) polygon.corners_.push_back(i);
  }
  for (std::size_t k = 0; k < polygon.corners_.size(); ++k) {
    const std::uint32_t corner = polygon.corners_[k];
    // Only the last side runs past vertex 0: it ends there, or its edge 0 starts there.
    const bool last = k + 1 == polygon.corners_.size();
    polygon.side_edge_.push_back(last && polygon.corners_.front() != 0 ? 0 : corner);
    polygon.side_lowest_vertex_.push_back(last ? 0 : corner);
  }
  return polygon;
}

}  // namespace gnomon
