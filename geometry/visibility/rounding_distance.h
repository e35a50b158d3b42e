#pragma once

/// Whether a point is within rounding of a polygon. Private to this folder.

#include <span>

#include "gnomon/point.h"

namespace gnomon::viewpoint {

/// How a point lies to a convex polygon.
enum class Nearness {
  apart,
  at_side,  ///< within rounding of it, and of one of its sides
  inside,   ///< within rounding of its plane and further inside
};

/// See resting_point. The corners are strictly convex, and coplanar but for rounding.
Nearness nearness(std::span<const Point3> corners, const Point3& p);

/// True if the point is within rounding of the line through the corners `side` and the one after it, seen along the
/// polygon's normal.
bool is_near_side(std::span<const Point3> corners, std::size_t side, const Point3& p);

/// True if one of the points lies beyond that line, by more than rounding.
bool reaches_beyond(std::span<const Point3> corners, std::size_t side, std::span<const Point3> points);

/// True if the planes with the normal and through the polygon's corners make an angle of at most 60 degrees;
/// `one_sided`: and the polygon's front and the normal are on one side.
bool faces_alike(std::span<const Point3> corners, const Point3& normal, bool one_sided);

}  // namespace gnomon::viewpoint
