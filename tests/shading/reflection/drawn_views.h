#pragma once

/// Numbers, vectors and eyes that tests of reflection draw.

#include <array>
#include <cmath>

#include "gnomon/reflection.h"
#include "tests/support/dice.h"

namespace gnomon::test_support {

inline constexpr std::array all_models = {ReflectionModel::phong, ReflectionModel::blinn,
                                          ReflectionModel::phong_classic, ReflectionModel::blinn_classic};

inline double between(Dice& dice, double low, double high) {
  return low + (high - low) * dice.draw(0, 1 << 30) / double(1 << 30);
}

inline Point3 drawn_vector(Dice& dice) {
  for (;;) {
    const Point3 p{between(dice, -1, 1), between(dice, -1, 1), between(dice, -1, 1)};
    const double square = p.x * p.x + p.y * p.y + p.z * p.z;
    if (square > 0.01 && square < 1) return p;
  }
}

inline Point3 added(const Point3& a, double s, const Point3& b) {
  return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

inline double product(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The way to an eye that sees light from `towards` mirrored, or nearly so.
inline Point3 mirrored(const Point3& towards, const Point3& n) {
  return added({-towards.x, -towards.y, -towards.z}, 2 * product(towards, n) / product(n, n), n);
}

}  // namespace gnomon::test_support
