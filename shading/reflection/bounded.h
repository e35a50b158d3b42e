#pragma once

/// Doubles that carry a bound of their error. Private to the libraries.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "shading/vector.h"

// These are a few instructions each; as calls they would take most of the time.
#define GNOMON_SHORT [[gnu::always_inline]]

namespace gnomon::shading {

/// A double that is off by at most `error` from the real number it stands for; the error may be infinite.
///
/// Exactness: every operation adds up what its operands are off and what it rounds. The errors are doubles themselves
/// and
///            rounded to nearest, fewer than 8 u of them at each step; final_bound() makes that good, and what
///            underflows.
struct Bounded {
  double value = 0;
  double error = 0;

  Bounded() = default;
  Bounded(double exact) : value(exact) {}  // NOLINT: doubles are exact
  Bounded(double nearest, double off) : value(nearest), error(off) {}
};

inline bool is_exact_zero(const Bounded& a) {
  return a.value == 0 && a.error == 0;
}

/// Divisors below this give nothing certain, so that what underflows grows by less than 2^200 each time.
inline constexpr double least_divisor = 0x1p-200;

/// A bound of all errors, of an expression with at most four divisions in a row whose operands are about 1 or less.
inline double final_bound(const Bounded& x) {
  if (is_exact_zero(x)) return 0;
  const double bound = 1.01 * x.error + 0x1p-250;
  return bound >= 0 ? bound : HUGE_VAL;
}

GNOMON_SHORT inline Bounded operator-(const Bounded& a) {
  return {-a.value, a.error};
}

GNOMON_SHORT inline Bounded operator+(const Bounded& a, const Bounded& b) {
  const double value = a.value + b.value;
  return {value, a.error + b.error + unit * std::fabs(value)};
}

GNOMON_SHORT inline Bounded operator-(const Bounded& a, const Bounded& b) {
  return a + -b;
}

/// What underflows is not taken for an exact 0.
GNOMON_SHORT inline Bounded operator*(const Bounded& a, const Bounded& b) {
  const double value = a.value * b.value;
  const double error =
      std::fabs(a.value) * b.error + (std::fabs(b.value) + b.error) * a.error + unit * std::fabs(value);
  const bool is_lost = value == 0 && error == 0 && !is_exact_zero(a) && !is_exact_zero(b);
  return {value, is_lost ? std::numeric_limits<double>::denorm_min() : error};
}

GNOMON_SHORT inline Bounded operator/(const Bounded& a, const Bounded& b) {
  const double least = std::fabs(b.value) - b.error;
  if (!(least > least_divisor)) return {0, HUGE_VAL};
  const double value = a.value / b.value;
  return {value, (a.error + std::fabs(value) * b.error) / least + unit * std::fabs(value)};
}

/// Of what is not negative, though its value may be.
inline Bounded sqrt(const Bounded& a) {
  const double value = std::sqrt(std::fmax(a.value, 0));
  if (a.value > a.error) return {value, a.error / value + unit * value};
  return {value, 1.01 * std::sqrt(std::fmax(a.value, 0) + a.error)};
}

/// Bound. On the way from the computed point to the true one the angle turns by what goes across over the distance from
/// the origin; the library's function errs by less than 2 u.
inline Bounded atan2(const Bounded& y, const Bounded& x) {
  const double value = std::atan2(y.value, x.value);
  // Squares that underflow leave less than the least divisor; those that overflow need more care.
  const double squared = x.value * x.value + y.value * y.value;
  const double apart = squared < HUGE_VAL ? std::sqrt(squared) : std::hypot(x.value, y.value);
  const double away = apart - x.error - y.error;
  const bool may_pass_half_a_turn = x.value - x.error < 0 && std::fabs(y.value) <= y.error;
  if (!(away > least_divisor) || may_pass_half_a_turn) return {value, HUGE_VAL};
  const double across = (std::fabs(x.value) + x.error) * y.error + (std::fabs(y.value) + y.error) * x.error;
  return {value, across / (away * away) + 4 * unit * std::fabs(value)};
}

inline Bounded cos(const Bounded& a) {
  return {std::cos(a.value), a.error + 2 * unit};
}

/// Bound. Close to 0 sines err as their angles do, and those are rounded in parts of themselves.
inline Bounded sin(const Bounded& a) {
  const double value = std::sin(a.value);
  return {value, a.error + 2 * unit * std::fabs(value)};
}

/// The larger of it and 0, which is off by no more.
inline Bounded positive_part(const Bounded& a) {
  return {std::fmax(a.value, 0), a.error};
}

/// Off by so much more.
inline Bounded widened(const Bounded& a, double error) {
  return {a.value, a.error + error};
}

/// (top square a + b) / below, as long recurrences take it: all factors of `a` are one number, and nothing is divided
/// but 1.
/// Bound. 1 / below, top / below and each product and sum of doubles rounds by u: the factor of `a` is off by 3 u of
/// itself, b / below by 2 u and the difference it may come from.
GNOMON_SHORT inline Bounded folded(double top, const Bounded& square, const Bounded& a, const Bounded& b,
                                   double below) {
  const double over = 1 / below, share = top * over;
  const double factor = share * square.value;
  const double first = factor * a.value, second = b.value * over;
  const double value = first + second;
  const double error = share * square.error * (std::fabs(a.value) + a.error) + std::fabs(factor) * a.error +
                       b.error * over + unit * (4 * std::fabs(first) + 2 * std::fabs(second) + std::fabs(value));
  if (value != 0 || error != 0) return {value, error};
  return (Bounded(top) * square * a + b) / Bounded(below);  // an exact 0, or what underflows
}

inline double middle(const Bounded& a) {
  return a.value;
}

/// At least its absolute value.
inline double largest(const Bounded& a) {
  return 1.01 * (std::fabs(a.value) + a.error);
}

/// -1 or +1 if that is certain, 0 for an exact 0; 2 for what is not certain.
inline int certain_sign(const Bounded& a) {
  if (a.value == 0 && a.error == 0) return 0;
  const double off = 1.01 * a.error;
  return a.value > off ? 1 : a.value < -off ? -1 : 2;
}

inline Bounded pi(const Bounded&) {
  return {std::numbers::pi, 1.3e-16};
}

inline Bounded bounded(const Bounded& a) {
  return {a.value, final_bound(a)};
}

}  // namespace gnomon::shading

#undef GNOMON_SHORT
