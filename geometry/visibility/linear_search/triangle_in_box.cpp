#include "geometry/visibility/linear_search/triangle_in_box.h"

#include <algorithm>
#include <cmath>

#include "geometry/bodies/boxes.h"
#include "geometry/visibility/viewpoint_rays.h"

namespace gnomon::viewpoint {
namespace {

/// A triangle and a box, seen from a corner of the triangle.
struct Seen {
  std::array<Vector, 2> corners;  ///< the others
  Vector low, high;
  double size = 0;  ///< largest coordinate

  /// True if the direction holds the two apart.
  bool are_apart(const Vector& v) const {
    const double a = dot(v, corners[0]);
    const double b = dot(v, corners[1]);
    const double least = std::min({0.0, a, b});
    const double most = std::max({0.0, a, b});
    const Vector near{v.x > 0 ? low.x : high.x, v.y > 0 ? low.y : high.y, v.z > 0 ? low.z : high.z};
    const Vector far{v.x > 0 ? high.x : low.x, v.y > 0 ? high.y : low.y, v.z > 0 ? high.z : low.z};
    const double bound = 16 * unit * sum_norm(v) * size + tiny;
    return dot(v, near) > most + bound || dot(v, far) < least - bound;
  }
};

}  // namespace

bool may_meet(const std::array<Point3, 3>& triangle, const Box3& box) {
  if (!overlap(box_around(triangle), box)) return false;
  const auto& [p, q, r] = triangle;
  Seen seen{{q - p, r - p}, box.min - p, box.max - p, 0};
  seen.size = std::max({size_of(seen.corners[0]), size_of(seen.corners[1]), size_of(seen.low), size_of(seen.high)});
  if (seen.are_apart(cross(seen.corners[0], seen.corners[1]))) return false;
  for (const Vector& side : {seen.corners[0], seen.corners[1], r - q}) {
    for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
      if (seen.are_apart(cross(axis, side))) return false;
    }
  }
  return true;
}

bool may_meet(std::span<const Point3> polygon, const Box3& box) {
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    if (may_meet({polygon[0], polygon[k], polygon[k + 1]}, box)) return true;
  }
  return false;
}

}  // namespace gnomon::viewpoint
