#pragma once

/// Directions of exact vectors, in doubles. Private to this folder.

#include <algorithm>

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/rounding.h"
#include "shading/vector.h"

namespace gnomon::shading {

/// Along a vector that is not zero, with a largest coordinate of 1 or -1.
/// Exactness: each coordinate is off by at most u times itself.
inline Vector direction_of(const ExactVector& v) {
  const Rational largest = std::max({Rational(abs(v.x)), Rational(abs(v.y)), Rational(abs(v.z))});
  const auto share = [&](const Rational& coordinate) { return nearest_double(Rational(coordinate / largest)); };
  return {share(v.x), share(v.y), share(v.z)};
}

}  // namespace gnomon::shading
