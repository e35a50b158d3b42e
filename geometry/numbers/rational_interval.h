#pragma once

#include <algorithm>

#include "geometry/numbers/kernel.h"

namespace gnomon {

/// A closed interval with rational ends.
struct RationalInterval {
  Rational low = 0;
  Rational high = 0;

  RationalInterval() = default;
  RationalInterval(Rational a, Rational b) : low(std::move(a)), high(std::move(b)) {}
  explicit RationalInterval(const Rational& x) : low(x), high(x) {}

  Rational width() const { return high - low; }
  /// +1 or -1 of an interval on one side of zero, else 0.
  int certain_sign() const { return low > 0 ? 1 : high < 0 ? -1 : 0; }
};

inline RationalInterval operator+(const RationalInterval& a, const RationalInterval& b) {
  return {Rational(a.low + b.low), Rational(a.high + b.high)};
}

inline RationalInterval operator-(const RationalInterval& a, const RationalInterval& b) {
  return {Rational(a.low - b.high), Rational(a.high - b.low)};
}

inline RationalInterval operator*(const RationalInterval& a, const RationalInterval& b) {
  const Rational p[] = {Rational(a.low * b.low), Rational(a.low * b.high), Rational(a.high * b.low),
                        Rational(a.high * b.high)};
  const auto [least, most] = std::minmax_element(std::begin(p), std::end(p));
  return {*least, *most};
}

/// Requires: a divisor on one side of zero.
inline RationalInterval operator/(const RationalInterval& a, const RationalInterval& b) {
  return a * RationalInterval(Rational(1 / b.high), Rational(1 / b.low));
}

/// The same with ends of so many bits or a few less, widened where need be.
RationalInterval rounded(const RationalInterval& x, unsigned bits);

}  // namespace gnomon
