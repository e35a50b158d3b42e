#pragma once

/// Vectors of numbers that know their errors. Private to the libraries.

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/rounding.h"
#include "shading/reflection/bounded.h"
#include "shading/reflection/precise.h"

namespace gnomon::shading {

/// The sum of three products, whose bound is added up at once. An exact 0, and what underflows to it, go the long way.
inline Bounded dot(const Vector3<Bounded>& a, const Vector3<Bounded>& b) {
  const double x = a.x.value * b.x.value, y = a.y.value * b.y.value, z = a.z.value * b.z.value;
  const double two = x + y, value = two + z;
  const auto off = [](const Bounded& p, const Bounded& q) {
    return std::fabs(p.value) * q.error + (std::fabs(q.value) + q.error) * p.error;
  };
  const double rounded = std::fabs(x) + std::fabs(y) + std::fabs(z) + std::fabs(two) + std::fabs(value);
  const double error = (off(a.x, b.x) + off(a.y, b.y)) + (off(a.z, b.z) + unit * rounded);
  return error != 0 ? Bounded(value, error) : a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
Vector3<Number> plus(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Number>
Vector3<Number> minus(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Number>
Vector3<Number> times(const Number& s, const Vector3<Number>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

template <class Number>
Vector3<Number> over(const Vector3<Number>& a, const Number& s) {
  return {a.x / s, a.y / s, a.z / s};
}

/// The same with one reciprocal for what its parts have in common.
inline Vector3<Bounded> over(const Vector3<Bounded>& a, const Bounded& s) {
  const double least = std::fabs(s.value) - s.error;
  if (!(least > least_divisor)) return {{0, HUGE_VAL}, {0, HUGE_VAL}, {0, HUGE_VAL}};
  const double grown = 1 / least;
  const auto part = [&](const Bounded& x) {
    const double value = x.value / s.value;
    return Bounded(value, (x.error + std::fabs(value) * s.error) * grown + unit * std::fabs(value));
  };
  return {part(a.x), part(a.y), part(a.z)};
}

template <class Number>
Vector3<Number> opposite(const Vector3<Number>& a) {
  return {-a.x, -a.y, -a.z};
}

template <class Number>
Number norm(const Vector3<Number>& a) {
  return sqrt(dot(a, a));
}

template <class Number>
Vector3<Number> unit_of(const Vector3<Number>& a) {
  return over(a, norm(a));
}

inline Vector middle_of(const Vector3<Bounded>& a) {
  return {a.x.value, a.y.value, a.z.value};
}

inline Vector middle_of(const Vector3<Precise>& a) {
  return {middle(a.x), middle(a.y), middle(a.z)};
}

/// A rational number as another: rounded to the nearest double, or enclosed.
template <class Number>
Number number_of(const Rational& exact);

template <>
inline Bounded number_of<Bounded>(const Rational& exact) {
  const double value = nearest_double(exact);
  return {value, exact == Rational(value) ? 0 : unit * std::fabs(value)};
}

template <>
inline Precise number_of<Precise>(const Rational& exact) {
  return Precise(exact);
}

template <class Number>
Vector3<Number> vector_of(const ExactVector& v) {
  return {number_of<Number>(v.x), number_of<Number>(v.y), number_of<Number>(v.z)};
}

/// x to the power n, n >= 0.
template <class Number>
Number power(Number x, int n) {
  Number result = 1.0;
  for (; n > 0; n /= 2) {
    if (n % 2 == 1) result = result * x;
    if (n > 1) x = x * x;
  }
  return result;
}

/// Over what is looked from a point, in unit vectors.
template <class Number>
struct Directions {
  Vector3<Number> normal;  ///< of the surface, N
  Vector3<Number> eye;     ///< to the eye, E
  Vector3<Number> mirror;  ///< R = 2 (N . E) N - E
  Number eye_height;       ///< N . E
};

/// Requires: vectors that are not zero, with coordinates of a size that can be squared.
template <class Number>
Directions<Number> directions(const Vector& normal, const Vector& to_eye) {
  const Vector3<Number> n = unit_of(Vector3<Number>{normal.x, normal.y, normal.z});
  const Vector3<Number> e = unit_of(Vector3<Number>{to_eye.x, to_eye.y, to_eye.z});
  const Number height = dot(n, e);
  return {n, e, minus(times(Number(2.0) * height, n), e), height};
}

}  // namespace gnomon::shading
