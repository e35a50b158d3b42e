#pragma once

#include <cmath>

#include "geometry/point.h"

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

}  // namespace gnomon
