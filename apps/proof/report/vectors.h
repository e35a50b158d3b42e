#pragma once

#include <cmath>

#include "gnomon/point.h"

namespace gnomon::report {

inline Point3 sum(const Point3& a, const Point3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Point3 difference(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Point3 scaled(double s, const Point3& a) {
  return {s * a.x, s * a.y, s * a.z};
}

/// The point at a share of the way from a to b.
inline Point3 between(const Point3& a, const Point3& b, double share) {
  return sum(a, scaled(share, difference(b, a)));
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

}  // namespace gnomon::report
