#pragma once

/// Directions in which the boundary is seen and areas on the light's plane, with bounds. Private to this folder.

#include <span>

#include "geometry/visibility/boundary_walk.h"
#include "geometry/visibility/fast_visibility.h"

namespace gnomon::viewpoint {

/// Twice an area in the two kept coordinates, and how far it may be off.
struct FlatArea {
  double doubled = 0;
  double error = 0;
};

/// Of a polygon; `doubled` is correctly rounded and positive.
FlatArea flat_area(std::span<const Point3> corners, int u, int v);

/// A direction whose coordinates are each off by at most `error`.
inline VisibleDirection direction_of(const Vector& v, double error) {
  return {v.x, v.y, v.z, root_of_three * error / size_of(v)};
}

inline VisibleDirection direction_of(const Ray& ray) {
  return {ray.direction.x, ray.direction.y, ray.direction.z, unit};
}

/// Where a station of an edge is seen: in which direction, and at which point of the light's plane.
struct VisiblePlace {
  VisibleDirection direction;
  FlatPoint flat;
};

/// Where two planes cross: the direction of a.normal x b.normal.
/// Bound. A cross product of normals errs by 4.1 u na nb from rounding and 2 (ea nb + na eb) from its factors.
inline VisiblePlace crossing(const LightPlane& light, const Plane& a, const Plane& b) {
  const Vector d = cross(a.normal, b.normal);
  const double error = 4.2 * unit * a.size * b.size + 2.1 * (a.error * b.size + a.size * b.error) + tiny;
  const double size = size_of(d);
  return {{d.x, d.y, d.z, root_of_three * error / size}, meeting_point(light, d, size, error)};
}

inline VisiblePlace visible_place(const Silhouettes& silhouettes, const LightPlane& light, const Edge& edge,
                                  const Station& station) {
  const std::uint32_t ray = ray_at(edge, station);
  if (ray != Station::none) return {direction_of(silhouettes.rays[ray]), silhouettes.flats[ray]};
  const Plane& crossed = silhouettes.planes[station.plane];
  const Plane& own = silhouettes.planes[edge.plane];
  return station.rising ? crossing(light, crossed, own) : crossing(light, own, crossed);
}

/// Twice the area between the origin and pieces from one point to another: the area of a region to their left if the
/// pieces are its boundary.
class AreaSum {
 public:
  /// Bound. With errors e and f of the two points, the product errs by 2 (|p| f + e |q| + e f) and 3 roundings; the sum
  /// by one rounding of what it is.
  void add(const FlatPoint& p, const FlatPoint& q) {
    const double p_size = std::max(std::fabs(p.u), std::fabs(p.v));
    const double q_size = std::max(std::fabs(q.u), std::fabs(q.v));
    sum_ += p.u * q.v - p.v * q.u;
    error_ += 2 * (p_size * q.error + q_size * p.error + p.error * q.error) + 4 * unit * p_size * q_size +
              unit * std::fabs(sum_) + tiny;
  }

  /// Exactness: the error bound covers all roundings, and is infinite or no number where a bound is out of reach.
  FlatArea total() const { return {sum_, error_ * (1 + 64 * unit)}; }

 private:
  double sum_ = 0;
  double error_ = 0;
};

}  // namespace gnomon::viewpoint
