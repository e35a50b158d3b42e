#pragma once

/// Areas on the light's plane, with bounds. Private to this folder.

#include <span>

#include "geometry/visibility/boundary_walk.h"
#include "geometry/visibility/fast_visibility.h"

namespace gnomon::sight {

/// Twice an area in the two kept coordinates, and how far it may be off.
struct FlatArea {
  double doubled = 0;
  double error = 0;
};

/// Of a polygon; `doubled` is correctly rounded and positive.
FlatArea flat_area(std::span<const Point3> corners, int u, int v);

/// The direction of a ray.
inline SightDirection direction_of(const Ray& ray) {
  return {ray.direction.x, ray.direction.y, ray.direction.z, root_of_three * unit * ray.size};
}

/// The ray of an input point that lies at the station, or Station::none.
inline std::uint32_t ray_at(const Edge& edge, const Station& station) {
  return station.kind == Station::Kind::start ? edge.start
         : station.kind == Station::Kind::end ? edge.end
                                              : station.vertex;
}

/// The direction in which two planes cross: of a.normal x b.normal.
/// Bound. A cross product of normals errs by 4.1 u na nb from rounding and 2 (ea nb + na eb) from its factors.
inline SightDirection crossing(const Plane& a, const Plane& b) {
  const Vector d = cross(a.normal, b.normal);
  const double error = 4.2 * unit * a.size * b.size + 2.1 * (a.error * b.size + a.size * b.error) + tiny;
  return {d.x, d.y, d.z, root_of_three * error};
}

/// The direction in which a station of an edge is seen.
inline SightDirection direction_of(const Outlines& outlines, const Edge& edge, const Station& station) {
  const std::uint32_t ray = ray_at(edge, station);
  if (ray != Station::none) return direction_of(outlines.rays[ray]);
  const Plane& crossed = outlines.planes[station.plane];
  const Plane& own = outlines.planes[edge.plane];
  return station.rising ? crossing(crossed, own) : crossing(own, crossed);
}

/// Twice the area between the origin and the pieces: the area of a region if the pieces are its boundary.
class AreaSum {
 public:
  AreaSum(const LightPlane& plane, const Outlines& outlines);

  /// Takes in a piece and what was made of it; the region lies left of it.
  void add(const Piece& piece, const BoundaryPiece& made);

  /// Exactness: the error bound covers all roundings, and is infinite or no number where a bound is out of reach.
  FlatArea total() const { return {sum_, error_ * (1 + 64 * unit)}; }

 private:
  FlatPoint from_origin(const Edge& edge, const Station& station, const SightDirection& direction) const;

  const LightPlane& plane_;
  const Outlines& outlines_;
  double sum_ = 0;
  double error_ = 0;
};

}  // namespace gnomon::sight
