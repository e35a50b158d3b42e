#pragma once

#include <cmath>

/// Sums and products of two doubles without rounding: the rounded result, and what was lost.
///
/// Requires: rounding to nearest, no contraction.

namespace gnomon {

/// An unevaluated sum of two doubles, the second at most half a unit in the last place of the first.
struct DoubleDouble {
  double high = 0;
  double low = 0;
};

/// a + b exactly; anything if that overflows.
inline DoubleDouble exact_sum(double a, double b) {
  const double s = a + b;
  const double b_rounded = s - a;
  return {s, (a - (s - b_rounded)) + (b - b_rounded)};
}

inline DoubleDouble exact_difference(double a, double b) {
  return exact_sum(a, -b);
}

/// A double cut into two halves of 26 bits, whose products with other halves are exact.
struct Halves {
  Halves(double whole = 0) : value(whole), upper(134217729.0 * whole) {  // NOLINT: exact, meant as a conversion
    upper = upper - (upper - whole);
    lower = whole - upper;
  }

  double value;
  double upper;
  double lower = 0;
};

/// a b, but for an error of 2^-1070 where something underflows; not a number if something overflows.
inline DoubleDouble exact_product(const Halves& a, const Halves& b) {
  const double p = a.value * b.value;
  return {p, ((a.upper * b.upper - p) + a.upper * b.lower + a.lower * b.upper) + a.lower * b.lower};
}

/// True if every number within `error` of the sum rounds to its high part.
inline bool rounds_to_high(const DoubleDouble& sum, double error) {
  const double reach = error * (1 + 0x1p-40) + 0x1p-1074;
  return sum.high + (sum.low + reach) * (1 + 0x1p-52) == sum.high &&
         sum.high + (sum.low - reach) * (1 + 0x1p-52) == sum.high && std::isfinite(sum.high);
}

}  // namespace gnomon
