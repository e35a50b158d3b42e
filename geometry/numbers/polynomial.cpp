#include "geometry/numbers/polynomial.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/numbers/rounding.h"

namespace gnomon {
namespace {

void trim(Coefficients& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

/// Divides by the greatest common divisor of the coefficients.
void make_primitive(Coefficients& p) {
  Integer common = 0;
  for (const Integer& c : p) {
    common = gcd(common, c);
    if (common == 1) return;
  }
  if (common == 0) return;
  for (Integer& c : p) c /= common;
}

Interval enclosure_of(const Rational& x) {
  const auto [low, high] = CGAL::to_interval(x);
  return {low, high};
}

std::optional<int> sign_of(const Interval& x) {
  if (x.inf() > 0) return 1;
  if (x.sup() < 0) return -1;
  return std::nullopt;
}

}  // namespace

Coefficients derivative(const Coefficients& p) {
  Coefficients result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(p[k] * static_cast<unsigned>(k));
  return result;
}

Coefficients pseudo_remainder(Coefficients a, const Coefficients& b) {
  const Integer lead = abs(b.back());
  const int sign = b.back() > 0 ? 1 : -1;
  while (a.size() >= b.size()) {
    const Integer top = a.back() * sign;
    const std::size_t shift = a.size() - b.size();
    for (Integer& c : a) c *= lead;
    for (std::size_t k = 0; k < b.size(); ++k) a[k + shift] -= top * b[k];
    trim(a);
    make_primitive(a);
  }
  return a;
}

Interval scaled(const Integer& c, long exponent) {
  if (c == 0) return 0;
  long own = 0;
  const double mantissa = mpz_get_d_2exp(&own, c.backend().data());  // rounded towards zero
  const long power = own - exponent;
  if (power < -900) return c > 0 ? Interval(0, 0x1p-899) : Interval(-0x1p-899, 0);
  const double less = std::ldexp(std::fabs(mantissa), static_cast<int>(power));
  const double more = std::ldexp(std::fabs(mantissa) + 0x1p-52, static_cast<int>(power));
  return c > 0 ? Interval(less, more) : Interval(-more, -less);
}

long exponent_of(const Integer& c) {
  return c == 0 ? 0 : static_cast<long>(msb(abs(c)));
}

Coefficients operator+(const Coefficients& a, const Coefficients& b) {
  Coefficients sum = a.size() < b.size() ? b : a;
  const Coefficients& other = a.size() < b.size() ? a : b;
  for (std::size_t k = 0; k < other.size(); ++k) sum[k] += other[k];
  return sum;
}

Coefficients operator-(const Coefficients& a, const Coefficients& b) {
  return a + Integer(-1) * b;
}

Coefficients operator*(const Coefficients& a, const Coefficients& b) {
  if (a.empty() || b.empty()) return {};
  Coefficients product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) product[i + k] += a[i] * b[k];
  }
  return product;
}

Coefficients operator*(const Integer& factor, const Coefficients& a) {
  Coefficients result = a;
  for (Integer& c : result) c *= factor;
  return result;
}

Integer homogeneous_value(const Coefficients& p, const Rational& x, std::size_t degree) {
  const Integer n = numerator(x), d = denominator(x);
  Integer value = 0, power = 1;
  for (std::size_t k = degree + 1; k-- > 0;) {
    value *= n;
    if (k < p.size()) value += p[k] * power;
    power *= d;
  }
  return value;
}

Polynomial::Polynomial(Coefficients coefficients) : coefficients_(std::move(coefficients)) {
  trim(coefficients_);
  make_primitive(coefficients_);
  long most = 0;
  for (const Integer& c : coefficients_) most = std::max(most, exponent_of(c));
  for (const Integer& c : coefficients_) near_.push_back(scaled(c, most));
}

std::optional<int> Polynomial::near_sign_at(const Rational& x) const {
  const CGAL::Protect_FPU_rounding<true> upward;
  const Interval at = enclosure_of(x);
  Interval value = 0;
  for (std::size_t k = near_.size(); k-- > 0;) value = value * at + near_[k];
  return sign_of(value);
}

int Polynomial::sign_at(const Rational& x) const {
  if (is_zero()) return 0;
  if (const auto sign = near_sign_at(x)) return *sign;
  return homogeneous_value(coefficients_, x, coefficients_.size() - 1).sign();
}

bool Polynomial::is_certainly_signed(const Interval& low, const Interval& high) const {
  if (is_zero()) return false;
  // Bernstein coefficients of q(s) = p(low + s (high - low)).
  const std::size_t n = near_.size();
  std::vector<Interval> shifted = near_;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    for (std::size_t k = n - 1; k-- > i;) shifted[k] += low * shifted[k + 1];
  }
  const Interval length = high - low;
  Interval power = 1;
  for (Interval& c : shifted) {
    c *= power;
    power *= length;
  }
  // From powers to Bernstein: b_i = sum over k <= i of C(i, k) / C(n-1, k) c_k.
  bool positive = true, negative = true;
  for (std::size_t i = 0; i < n; ++i) {
    Interval b = 0, weight = 1;
    for (std::size_t k = 0; k <= i; ++k) {
      b += weight * shifted[k];
      if (k < i) weight = weight * Interval(double(i - k)) / Interval(double(n - 1 - k));
    }
    positive = positive && b.inf() > 0;
    negative = negative && b.sup() < 0;
  }
  return positive || negative;
}

Polynomial greatest_common_divisor(Polynomial a, Polynomial b) {
  Coefficients p = a.coefficients(), q = b.coefficients();
  if (p.size() < q.size()) std::swap(p, q);
  while (!q.empty()) {
    Coefficients rest = pseudo_remainder(std::move(p), q);
    p = std::move(q);
    q = std::move(rest);
  }
  return Polynomial(std::move(p));
}

Polynomial quotient(const Polynomial& a, const Polynomial& b) {
  Coefficients rest = a.coefficients();
  const Coefficients& by = b.coefficients();
  Coefficients result(rest.size() - by.size() + 1);
  // Exact division of primitive polynomials stays in the integers.
  for (std::size_t shift = result.size(); shift-- > 0;) {
    result[shift] = rest[shift + by.size() - 1] / by.back();
    for (std::size_t k = 0; k < by.size(); ++k) rest[k + shift] -= result[shift] * by[k];
  }
  return Polynomial(std::move(result));
}

}  // namespace gnomon
