#pragma once

#include <array>

#include "geometry/numbers/kernel.h"
#include "gnomon/point.h"

namespace gnomon {

/// A point or a vector with rational coordinates.
using ExactPoint = std::array<Rational, 3>;

inline ExactPoint exact_point(const Point3& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

inline ExactPoint difference(const ExactPoint& a, const ExactPoint& b) {
  return {Rational(a[0] - b[0]), Rational(a[1] - b[1]), Rational(a[2] - b[2])};
}

inline ExactPoint cross(const ExactPoint& a, const ExactPoint& b) {
  return {Rational(a[1] * b[2] - a[2] * b[1]), Rational(a[2] * b[0] - a[0] * b[2]),
          Rational(a[0] * b[1] - a[1] * b[0])};
}

inline Rational dot(const ExactPoint& a, const ExactPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace gnomon
