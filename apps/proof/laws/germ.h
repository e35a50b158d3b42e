#pragma once

/// Numbers that depend on a small positive t: what an exact quantity does just after a point of a path.

#include <vector>

#include "geometry/numbers/kernel.h"

namespace gnomon::laws {

using Integer = boost::multiprecision::mpz_int;

/// A polynomial in t with whole coefficients, the constant one first; no coefficient stands for zero.
///
/// Definition: such polynomials are ordered by what they are for all t > 0 that are small enough, so the sign is that
///             of the first coefficient that is not zero.
/// Exactness:  nothing is cut off.
class Germ {
 public:
  Germ() = default;
  explicit Germ(std::vector<Integer> coefficients) : coefficients_(std::move(coefficients)) {}

  /// -1, 0 or +1.
  int sign() const;
  bool is_zero() const { return sign() == 0; }

  /// The coefficient of that power.
  Integer operator[](std::size_t power) const {
    return power < coefficients_.size() ? coefficients_[power] : Integer(0);
  }
  std::size_t size() const { return coefficients_.size(); }

  friend Germ operator+(const Germ& a, const Germ& b);
  friend Germ operator-(const Germ& a, const Germ& b);
  friend Germ operator*(const Germ& a, const Germ& b);
  Germ operator-() const;

 private:
  std::vector<Integer> coefficients_;
};

/// The first three coefficients of a power series in t: a value, its slope, and half its second derivative.
struct Jet {
  Rational value = 0;
  Rational slope = 0;
  Rational bend = 0;

  friend bool operator==(const Jet&, const Jet&) = default;
};

Jet operator+(const Jet& a, const Jet& b);
Jet operator-(const Jet& a, const Jet& b);
Jet operator*(const Jet& a, const Jet& b);
Jet operator*(const Rational& s, const Jet& a);

/// The series of a / b.
///
/// Requires:  b is not zero, and a / b has a limit.
/// Exactness: a common power of t is divided out first.
Jet quotient(const Germ& a, const Germ& b);

}  // namespace gnomon::laws
