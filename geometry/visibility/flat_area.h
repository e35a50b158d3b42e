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

/// The direction in which a station of an edge is seen.
SightDirection direction_of(const Edge& edge, const Station& station);

/// Twice the area between the origin and the pieces: the area of a region if the pieces are its boundary.
class AreaSum {
 public:
  AreaSum(const LightPlane& plane, const Ray& origin);

  /// Takes in a piece and what was made of it; the region lies left of it.
  void add(const Piece& piece, const BoundaryPiece& made);

  /// Exactness: the error bound covers all roundings, and is infinite or no number where a bound is out of reach.
  FlatArea total() const { return {sum_, error_ * (1 + 64 * unit)}; }

 private:
  FlatPoint from_origin(const SightDirection& direction, bool is_corner) const;

  const LightPlane& plane_;
  FlatPoint origin_;
  double sum_ = 0;
  double error_ = 0;
};

}  // namespace gnomon::sight
