#pragma once

#include <cmath>

namespace gnomon {

/// A real number known to lie within `error` of the unevaluated sum high + low.
///
/// Requires: rounding to nearest, no contraction, while any operation runs.
/// Bounds:   each operation adds to the propagated bounds at most 2^-103 of its result, which covers the 3 u^2 of the
///           sum and the 5 u^2 of the product of double words (u = 2^-53; Joldes, Muller, Popescu 2017), and 2^-1060
///           for what underflows. Overflow makes the error infinite or not a number: comparisons with it must be
///           written so that they then fail.
class DoubleDouble {
 public:
  DoubleDouble(double value = 0) : high_(value) {}  // NOLINT: exact, meant as a conversion

  double high() const { return high_; }
  double low() const { return low_; }
  double error() const { return error_; }

  /// Upper bound of the absolute value.
  double magnitude() const { return std::abs(high_) * (1 + 0x1p-51) + error_; }

  DoubleDouble operator-() const { return {-high_, -low_, error_}; }

  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const auto [s, e] = two_sum(a.high_, b.high_);
    const auto [t, f] = two_sum(a.low_, b.low_);
    const auto [h, l] = quick_two_sum(s, e + t);
    const auto [high, low] = quick_two_sum(h, l + f);
    return {high, low, (a.error_ + b.error_ + 0x1p-103 * std::abs(high)) * (1 + 0x1p-40)};
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const auto [p, e] = two_product(a.high_, b.high_);
    const auto [high, low] = quick_two_sum(p, e + (a.high_ * b.low_ + a.low_ * b.high_));
    const double propagated = (std::abs(a.high_) + a.error_) * b.error_ + std::abs(b.high_) * a.error_;
    return {high, low, (propagated + 0x1p-103 * std::abs(high)) * (1 + 0x1p-40) + 0x1p-1060};
  }

  /// Encloses the quotient; the error is infinite or not a number if the divisor may be zero.
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.high_ / b.high_;
    const DoubleDouble rest = a - DoubleDouble(first) * b;
    const auto [high, low] = quick_two_sum(first, rest.high_ / b.high_);
    const DoubleDouble residual = a - DoubleDouble(high, low, 0) * b;
    const double least = std::abs(b.high_) * (1 - 0x1p-51) - b.error_;
    return {high, low, least > 0 ? residual.magnitude() / least * (1 + 0x1p-40) + 0x1p-1070 : HUGE_VAL};
  }

  /// True if every number within the error of high + low rounds to `high`.
  bool rounds_to_high() const {
    const double reach = error_ * (1 + 0x1p-40) + 0x1p-1074;
    return high_ + (low_ + reach) * (1 + 0x1p-52) == high_ && high_ + (low_ - reach) * (1 + 0x1p-52) == high_ &&
           std::isfinite(high_);
  }

 private:
  struct Sum {
    double sum;
    double rest;
  };
  DoubleDouble(double high, double low, double error) : high_(high), low_(low), error_(error) {}

  static Sum two_sum(double a, double b) {
    const double s = a + b;
    const double bb = s - a;
    return {s, (a - (s - bb)) + (b - bb)};
  }
  static Sum quick_two_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  static Sum two_product(double a, double b) {
    const double p = a * b;
    const auto [ah, al] = split(a);
    const auto [bh, bl] = split(b);
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
  }
  static Sum split(double a) {
    const double c = 134217729.0 * a;
    const double high = c - (c - a);
    return {high, a - high};
  }

  double high_ = 0;
  double low_ = 0;
  double error_ = 0;
};

}  // namespace gnomon
