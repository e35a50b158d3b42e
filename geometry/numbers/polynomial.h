#pragma once

/// Polynomials in one variable with integer coefficients: signs and real roots, exactly. Private to geometry/.

#include <memory>
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

/// A polynomial's real roots, each counted once.
class RootCounter {
 public:
  /// Requires: not zero.
  explicit RootCounter(const Polynomial& p);

  /// The same roots, all of them simple.
  const std::shared_ptr<const Polynomial>& square_free() const { return square_free_; }

  /// In low < x <= high.
  int count(const Rational& low, const Rational& high) const;

 private:
  int variations(const Rational& x) const;

  std::shared_ptr<const Polynomial> square_free_;
  std::vector<Polynomial> chain_;  ///< Sturm's
};

/// A real root: the only one of `of`, which has simple roots alone, in low < x < high; or rational, low = x = high.
struct RealRoot {
  std::shared_ptr<const Polynomial> of;
  Rational low;
  Rational high;

  bool is_rational() const { return low == high; }
};

RealRoot rational_root(const Rational& x);

/// The real roots in low <= x <= high, ascending, their intervals apart. Requires: not zero.
std::vector<RealRoot> real_roots(const Polynomial& p, const Rational& low, const Rational& high);

/// Halves the interval around a root.
void refine(RealRoot& root);

/// Signs of a - b. They refine what is compared.
int compare(RealRoot& a, const Rational& b);
int compare(RealRoot& a, RealRoot& b);

/// A rational number strictly between, a short one where possible. Requires: a < b.
Rational number_between(RealRoot& a, RealRoot& b);

/// The sign of a polynomial at a root, which is refined.
int sign_at(const Polynomial& p, RealRoot& root);

/// A short rational number in low < x < high. Requires: low < high.
Rational short_number_between(const Rational& low, const Rational& high);

}  // namespace gnomon
