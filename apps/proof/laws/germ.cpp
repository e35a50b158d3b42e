#include "apps/proof/laws/germ.h"

#include <algorithm>

namespace gnomon::laws {

int Germ::sign() const {
  for (const Integer& c : coefficients_) {
    if (c.sign() != 0) return c.sign();
  }
  return 0;
}

Germ operator+(const Germ& a, const Germ& b) {
  Germ sum = a.size() < b.size() ? b : a;
  const Germ& shorter = a.size() < b.size() ? a : b;
  for (std::size_t i = 0; i < shorter.size(); ++i) sum.coefficients_[i] += shorter.coefficients_[i];
  return sum;
}

Germ operator-(const Germ& a, const Germ& b) {
  Germ difference = a;
  if (a.size() < b.size()) difference.coefficients_.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) difference.coefficients_[i] -= b.coefficients_[i];
  return difference;
}

Germ operator*(const Germ& a, const Germ& b) {
  if (a.size() == 0 || b.size() == 0) return {};
  std::vector<Integer> product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) product[i + k] += a.coefficients_[i] * b.coefficients_[k];
  }
  return Germ(std::move(product));
}

Germ Germ::operator-() const {
  Germ negative = *this;
  for (Integer& c : negative.coefficients_) c = -c;
  return negative;
}

Jet operator+(const Jet& a, const Jet& b) {
  return {Rational(a.value + b.value), Rational(a.slope + b.slope), Rational(a.bend + b.bend)};
}

Jet operator-(const Jet& a, const Jet& b) {
  return {Rational(a.value - b.value), Rational(a.slope - b.slope), Rational(a.bend - b.bend)};
}

Jet operator*(const Jet& a, const Jet& b) {
  return {Rational(a.value * b.value), Rational(a.value * b.slope + a.slope * b.value),
          Rational(a.value * b.bend + a.slope * b.slope + a.bend * b.value)};
}

Jet operator*(const Rational& s, const Jet& a) {
  return {Rational(s * a.value), Rational(s * a.slope), Rational(s * a.bend)};
}

Jet quotient(const Germ& a, const Germ& b) {
  std::size_t least = 0;
  while (b[least] == 0) ++least;
  const auto at = [least](const Germ& g, std::size_t power) { return Rational(g[least + power]); };
  const Rational b0 = at(b, 0), b1 = at(b, 1), b2 = at(b, 2);
  Jet result;
  result.value = at(a, 0) / b0;
  result.slope = (at(a, 1) - result.value * b1) / b0;
  result.bend = (at(a, 2) - result.value * b2 - result.slope * b1) / b0;
  return result;
}

}  // namespace gnomon::laws
