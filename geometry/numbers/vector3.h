#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <type_traits>

#include "gnomon/point.h"

namespace gnomon {

/// A point or vector of space in any numbers: doubles, intervals, rationals. Signs that are taken of doubles alone need
/// a bound; each says its own.
template <class Number>
struct Vector3 {
  Number x{};
  Number y{};
  Number z{};

  const Number& operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  Number& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }

  friend bool operator==(const Vector3&, const Vector3&) = default;
  friend std::weak_ordering operator<=>(const Vector3&, const Vector3&) = default;
};

/// Homogeneous coordinates (x, y, z, w), or a plane's coefficients.
template <class Number>
using Quadruple = std::array<Number, 4>;

template <class Number>
Vector3<Number> operator+(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {Number(a.x + b.x), Number(a.y + b.y), Number(a.z + b.z)};
}

template <class Number>
Vector3<Number> operator-(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {Number(a.x - b.x), Number(a.y - b.y), Number(a.z - b.z)};
}

template <class Number>
Vector3<Number> operator*(const std::type_identity_t<Number>& s, const Vector3<Number>& a) {
  return {Number(s * a.x), Number(s * a.y), Number(s * a.z)};
}

template <class Number>
Number dot(const Vector3<Number>& a, const Vector3<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
Vector3<Number> cross(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {Number(a.y * b.z - a.z * b.y), Number(a.z * b.x - a.x * b.z), Number(a.x * b.y - a.y * b.x)};
}

template <class Number>
bool is_zero(const Vector3<Number>& a) {
  return a.x == 0 && a.y == 0 && a.z == 0;
}

/// The step from one point to another, each coordinate rounded once.
inline Vector3<double> step(const Point3& from, const Point3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

inline double sum_norm(const Vector3<double>& a) {
  return std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z);
}

}  // namespace gnomon
