#pragma once

/// Curves in intervals: what these tell spares exact arithmetic. Private to geometry/.

#include <array>

#include "geometry/conics/flat_curve.h"

namespace gnomon::conic {

/// A point, somewhere in a box.
struct NearPoint {
  Interval x = 0;
  Interval y = 0;
};

Interval enclosure(const Rational& x);
Interval enclosure(const Range& range);

inline bool are_apart(const Interval& a, const Interval& b) {
  return a.sup() < b.inf() || b.sup() < a.inf();
}

/// A curve's coefficients in intervals. Requires of it and of all functions: the rounding mode is protected.
struct NearCurve {
  std::array<std::array<Interval, 3>, 3> point;  ///< of w, x, y, by powers of t, up to a positive factor
  std::array<Interval, 6> form;                  ///< up to a positive factor

  explicit NearCurve(const FlatCurve& curve);
};

/// Whether the points of the other curve on a range of its parameter certainly lie off this one.
bool certainly_avoids(const NearCurve& curve, const NearCurve& other, const Interval& from, const Interval& to);

/// The coefficients of the curve's form at p + s d, as form_on_line has them, up to one positive factor.
std::array<Interval, 3> form_on_line(const NearCurve& curve, const NearPoint& p, const NearPoint& d);

}  // namespace gnomon::conic
