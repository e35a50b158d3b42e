#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "gnomon/point.h"

namespace gnomon {

/// True if the bounds are finite and each minimum lies below its maximum.
inline bool has_interior(const Box2& box) {
  const bool finite =
      std::isfinite(box.min.x) && std::isfinite(box.min.y) && std::isfinite(box.max.x) && std::isfinite(box.max.y);
  return finite && box.min.x < box.max.x && box.min.y < box.max.y;
}

/// True if the bounds are finite and each minimum lies below its maximum.
inline bool has_interior(const Box3& box) {
  const Box2 ground{{box.min.x, box.min.y}, {box.max.x, box.max.y}};
  return has_interior(ground) && std::isfinite(box.min.z) && std::isfinite(box.max.z) && box.min.z < box.max.z;
}

/// A box without a point.
inline Box3 empty_box3() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

/// Widens the box so that it holds the point.
inline void include(Box3& box, const Point3& p) {
  box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
  box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
}

/// The smallest box that holds all points.
inline Box3 box_around(std::span<const Point3> points) {
  Box3 box = empty_box3();
  for (const Point3& p : points) include(box, p);
  return box;
}

/// True if the boxes have a point in common.
inline bool overlap(const Box3& a, const Box3& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

/// True if the point lies in the box.
inline bool holds(const Box3& box, const Point3& p) {
  return overlap(box, {p, p});
}

}  // namespace gnomon
