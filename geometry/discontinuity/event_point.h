#pragma once

/// Points that make events, and brackets of four of them, in intervals and exactly. Private to this folder.

#include <array>
#include <cstdint>
#include <optional>

#include "geometry/numbers/kernel.h"
#include "geometry/numbers/vector3.h"
#include "gnomon/point.h"

namespace gnomon::event {

/// A point of the scene, a point constructed from it, or a direction towards a light infinitely far away.
struct EventPoint {
  enum class Kind : std::uint8_t { input, direction, constructed };
  Kind kind = Kind::input;
  Point3 input;                                 ///< the point or the direction; of a constructed one nearby
  std::optional<Quadruple<ExactReal>> exact{};  ///< of a constructed one
};

/// The coordinates in intervals or exact numbers.
template <class Number>
Quadruple<Number> coordinates(const EventPoint& point);
template <>
Quadruple<ExactReal> coordinates(const EventPoint& point);
template <>
Quadruple<Interval> coordinates(const EventPoint& point);

/// The volume of the simplex v, a, b, c, up to a positive factor that depends on each point alone: positive if c lies
/// on the side of the plane (v, a, b) from which these run counterclockwise.
template <class Number>
Number bracket(const EventPoint& v, const EventPoint& a, const EventPoint& b, const EventPoint& c);

/// Sign of a bracket: -1, 0, +1.
/// Requires: the rounding mode is protected. Exactness: intervals where they tell, else exact.
int orientation(const EventPoint& v, const EventPoint& a, const EventPoint& b, const EventPoint& c);

/// Sign of an interval, if it has one.
inline std::optional<int> certain_sign(const Interval& x) {
  if (x.inf() > 0) return 1;
  if (x.sup() < 0) return -1;
  if (x.inf() == 0 && x.sup() == 0) return 0;
  return std::nullopt;
}

/// An interval around an exact number.
inline Interval enclosure(const ExactReal& x) {
  const auto [low, high] = CGAL::to_interval(x);
  return {low, high};
}

}  // namespace gnomon::event
