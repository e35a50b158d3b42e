#pragma once

/// Vectors in doubles. Private to this folder.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/numbers/vector3.h"
#include "geometry/visibility/fast_visibility.h"
#include "gnomon/point.h"
#include "shading/pair.h"

namespace gnomon::shading {

/// The largest relative error of one rounding.
inline constexpr double unit = 0x1p-53;

using Vector = Vector3<double>;
using VectorPair = Vector3<Pair>;

inline Vector vector(const VisibleDirection& d) {
  return {d.x, d.y, d.z};
}

inline VectorPair vectors(const VisibleDirection& a, const VisibleDirection& b) {
  return {Pair{a.x, b.x}, Pair{a.y, b.y}, Pair{a.z, b.z}};
}

inline VectorPair twice(const Vector& a) {
  return {Pair{a.x, a.x}, Pair{a.y, a.y}, Pair{a.z, a.z}};
}

inline double length(const Vector& a) {
  return std::sqrt(dot(a, a));
}

/// x times 2^power, rounded once: exact unless it underflows or overflows. As std::scalbn, which is a call.
inline double times_two_to(double x, int power) {
  const bool is_normal = power >= -1022 && power <= 1023;
  return is_normal ? x * std::bit_cast<double>(static_cast<std::uint64_t>(power + 1023) << 52) : std::scalbn(x, power);
}

/// The binary exponent of the largest coordinate; 0 if that is 0 or not finite.
inline int exponent(const Vector& a) {
  const double size = std::fmax(std::fmax(std::fabs(a.x), std::fabs(a.y)), std::fabs(a.z));
  if (!(size > 0 && size < HUGE_VAL)) return 0;
  const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(size) >> 52);
  return biased > 0 ? biased - 1023 : std::ilogb(size);
}

/// Times a power of two: exact but for coordinates that underflow.
inline Vector scaled(const Vector& a, int power) {
  return {times_two_to(a.x, power), times_two_to(a.y, power), times_two_to(a.z, power)};
}

/// The direction with a largest coordinate from 1 to 2, if it has a length that is finite. What underflows beside that
/// is far below rounding.
inline Vector of_size_one(const Vector& a) {
  return scaled(a, -exponent(a));
}

/// A bound that also covers what underflows in the value or in the bound. Subnormals are slow: few see one.
inline double with_underflow(double bound) {
  return bound < 1e-290 ? bound + 2 * std::numeric_limits<double>::denorm_min() : bound;
}

/// At least the length, and less than twice it.
template <class Number>
Number length_above(const Vector3<Number>& a) {
  return magnitude(a.x) + magnitude(a.y) + magnitude(a.z);
}

}  // namespace gnomon::shading
