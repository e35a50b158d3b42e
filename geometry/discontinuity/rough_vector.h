#pragma once

/// Vectors in doubles, for searches that let through what doubles do not tell. Private to this folder.

#include <array>
#include <cmath>

#include "gnomon/point.h"

namespace gnomon::event {

using RoughVector = std::array<double, 3>;

inline RoughVector difference(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline RoughVector cross(const RoughVector& a, const RoughVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double dot(const RoughVector& a, const RoughVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double sum_norm(const RoughVector& a) {
  return std::fabs(a[0]) + std::fabs(a[1]) + std::fabs(a[2]);
}

}  // namespace gnomon::event
