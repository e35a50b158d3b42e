#pragma once

#include <array>

#include "gnomon/point.h"

namespace gnomon {

/// A point's coordinates in an order; equal for equal places, as zero has two signs in doubles and one place in space.
using PlaceKey = std::array<double, 3>;

inline PlaceKey place_key(const Point3& p) {
  return {p.x + 0.0, p.y + 0.0, p.z + 0.0};
}

}  // namespace gnomon
