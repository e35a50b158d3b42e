#pragma once

/// Half-spaces in doubles, by which boxes are searched. Private to this folder.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bodies/box_hierarchy.h"
#include "geometry/numbers/vector3.h"
#include "gnomon/point.h"

namespace gnomon::event {

/// A vector in doubles, for searches that let through what doubles do not tell.
using RoughVector = Vector3<double>;

/// A half-space of which points certainly outside can be told, in doubles.
///
/// Exactness: `error` times the distance in the sum norm from `origin`, plus `offset`, bounds what the value at a point
///            may be off.
struct RoughHalfSpace {
  RoughVector normal{};  ///< points inside
  Point3 origin;
  double error = 0;
  double offset = 0;
};

/// The half-spaces on both sides of a plane through an origin, spanned by two vectors; `normal` is their cross product.
/// The vectors are exact up to one rounding of each coordinate.
RoughHalfSpace rough_half_space(const Point3& origin, const RoughVector& u, const RoughVector& v);

/// The half-space bounded by the plane through `origin` along a vector and at right angles to another half-space's,
/// that holds `inside`.
RoughHalfSpace rough_side(const RoughHalfSpace& plane, const RoughVector& along, const Point3& origin,
                          const Point3& inside);

inline RoughHalfSpace reversed(RoughHalfSpace h) {
  h.normal = -1 * h.normal;
  return h;
}

/// The same plane with the side that holds `inside`; everything is let through where doubles do not tell.
RoughHalfSpace turned_to(const RoughHalfSpace& plane, const Point3& inside);

/// True if the point certainly lies outside.
bool is_outside(const RoughHalfSpace& half_space, const Point3& point);

/// Replaces `found` by the numbers of all boxes that meet all half-spaces, and some others, in no order.
/// Exactness: conservative; a box is left out only where it lies outside of one half-space beyond all rounding.
void find_boxes(const BoxHierarchy& boxes, std::span<const RoughHalfSpace> half_spaces,
                std::vector<std::uint32_t>& found);

}  // namespace gnomon::event
