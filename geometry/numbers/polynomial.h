#pragma once

/// Polynomials in one variable with integer coefficients: signs, exactly. Private to geometry/.

#include <optional>
#include <vector>

#include "geometry/numbers/kernel.h"

namespace gnomon {

/// Coefficients in ascending order of powers.
using Coefficients = std::vector<Integer>;

Coefficients operator+(const Coefficients& a, const Coefficients& b);
Coefficients operator-(const Coefficients& a, const Coefficients& b);
Coefficients operator*(const Coefficients& a, const Coefficients& b);
Coefficients operator*(const Integer& factor, const Coefficients& a);

/// The value at n / d, times d^degree with d > 0, for a degree of at least that of the polynomial.
Integer homogeneous_value(const Coefficients& p, const Rational& x, std::size_t degree);

/// An interval around c / 2^exponent. Requires: the rounding mode is protected.
Interval scaled(const Integer& c, long exponent);

/// The number of bits of an integer, less one; 0 of zero.
long exponent_of(const Integer& c);

/// A polynomial, up to a positive factor.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(Coefficients coefficients);

  bool is_zero() const { return coefficients_.empty(); }
  /// -1 of zero.
  int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  const Coefficients& coefficients() const { return coefficients_; }

  /// Exact: intervals where they tell.
  int sign_at(const Rational& x) const;

  /// True if intervals tell that it has one sign, and no zero, on low <= x <= high.
  bool is_certainly_signed(const Interval& low, const Interval& high) const;

 private:
  std::optional<int> near_sign_at(const Rational& x) const;

  Coefficients coefficients_;
  std::vector<Interval> near_;  ///< the coefficients, divided by a power of two
};

/// The greatest common divisor, up to a factor. Requires: one of them is not zero.
Polynomial greatest_common_divisor(Polynomial a, Polynomial b);

/// a / b. Requires: it divides.
Polynomial quotient(const Polynomial& a, const Polynomial& b);

Coefficients derivative(const Coefficients& p);

/// The remainder of a by b times a positive number.
Coefficients pseudo_remainder(Coefficients a, const Coefficients& b);

}  // namespace gnomon
