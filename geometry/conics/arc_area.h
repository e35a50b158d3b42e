#pragma once

/// Where a curve's points lie, and what area lies between an arc and its chord. Private to geometry/.

#include "geometry/conics/flat_curve.h"
#include "geometry/numbers/rational_interval.h"

namespace gnomon::conic {

/// A point, somewhere in a box.
struct PointBox {
  RationalInterval x;
  RationalInterval y;
};

/// Around the point at a root, which is refined. Each side is at most 2^-bits of the larger coordinate.
/// Requires: a point not at infinity.
PointBox point_box(const FlatCurve& curve, RealRoot& root, unsigned bits);

/// Twice the area between an arc and its chord, positive if the arc runs on the chord's right side as the parameter
/// grows.
///
/// Method: an arc with Bezier points of the weights w0, w1, w2 > 0 bounds T kappa(u) with its chord, T the area of the
///         triangle of the three points, u = w1^2 / (w0 w2): with x = 1 - u, |x| < 1, kappa = 2/3 - 2x/15 (c_0 + c_1 x
///         +
///         ...), c_0 = 1, c_m+1 = c_m (m + 2)/(m + 7/2). The arc is halved until |x| <= 1/2; the rest of the series is
///         then below its last term.
/// Error:  the interval holds it; about 2^-bits of the area of the triangle.
RationalInterval doubled_segment(const FlatCurve& curve, RealRoot& from, RealRoot& to, unsigned bits);

}  // namespace gnomon::conic
