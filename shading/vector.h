#pragma once

/// Vectors in doubles. Private to this folder.

#include <cmath>

#include "geometry/point.h"
#include "geometry/visibility/fast_visibility.h"

namespace gnomon::shading {

struct Vector {
  double x = 0;
  double y = 0;
  double z = 0;
};

inline Vector vector(const SightDirection& d) {
  return {d.x, d.y, d.z};
}

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Vector operator*(double s, const Vector& a) {
  return {s * a.x, s * a.y, s * a.z};
}

inline double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(const Vector& a) {
  return std::sqrt(dot(a, a));
}

/// At least the length, and less than twice it.
inline double length_above(const Vector& a) {
  return std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z);
}

}  // namespace gnomon::shading
