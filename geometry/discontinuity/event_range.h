#pragma once

#include <cmath>

#include "gnomon/point.h"

namespace gnomon {

/// The least and the largest size of a coordinate that is not zero in scenes whose receivers are to be divided:
/// products of a few differences of such coordinates neither vanish nor overflow in doubles.
inline constexpr double least_event_coordinate = 0x1p-200;
inline constexpr double largest_event_coordinate = 0x1p200;

/// True if each coordinate is zero or of a size in that range.
inline bool is_in_event_range(const Point3& p) {
  const auto fits = [](double c) {
    const double size = std::fabs(c);
    return size == 0 || (least_event_coordinate <= size && size <= largest_event_coordinate);
  };
  return fits(p.x) && fits(p.y) && fits(p.z);
}

}  // namespace gnomon
