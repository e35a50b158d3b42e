#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "geometry/numbers/kernel.h"
#include "geometry/planar/exact_polygon.h"
#include "gnomon/flatland.h"

namespace gnomon::planar {

/// Bounds the error of a cross product of differences of doubles, `magnitude` being the sum of its two products'
/// magnitudes as computed: see turn().
inline double product_error(double magnitude) {
  return 5 * 0x1p-53 * magnitude + std::numeric_limits<double>::min();
}

/// Bounds |nearest_double(x) - x|, and covers the rounding of a sum with it.
inline double rounding_error(double x) {
  return 0x1p-51 * std::fabs(x) + std::numeric_limits<double>::min();
}

inline ExactPoint exact(const Point2& p) {
  return {Rational(p.x), Rational(p.y)};
}

/// Where the foot of a point lies along a linear light: 0 at its end 0, 1 at its end 1.
Rational place_along(std::span<const Point2> light, const ExactPoint& point);

/// Twice the signed area of the triangle over a linear light with the tip `point`; positive left of it.
Rational height_over(std::span<const Point2> light, const ExactPoint& point);

/// Where a blocker crosses a linear light's line.
/// Requires: its ends strictly on both sides of the line.
ExactPoint crossing_point(std::span<const Point2> light, const BlockerSegment& blocker);
Rational crossing_place(std::span<const Point2> light, const BlockerSegment& blocker);

}  // namespace gnomon::planar
