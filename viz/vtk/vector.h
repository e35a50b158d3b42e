#pragma once

#include <cmath>

#include "gnomon/point.h"

namespace gnomon::viz {

/// Vectors for pictures, in plain doubles.
inline Point3 operator+(const Point3& a, const Point3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Point3 operator-(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Point3 operator*(double s, const Point3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Point3& a) {
  return std::hypot(a.x, a.y, a.z);
}

/// The zero vector stays as it is.
inline Point3 unit(const Point3& a) {
  return length(a) > 0 ? 1 / length(a) * a : a;
}

}  // namespace gnomon::viz
