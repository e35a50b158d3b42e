#pragma once

#include <vector>

#include "geometry/bodies/body.h"
#include "geometry/bodies/sides.h"
#include "geometry/numbers/orientation.h"

namespace gnomon {

/// A light and a blocker of any kind in any position, and the signs of determinants of their points.
///
/// Exactness: all signs are exact.
class BodyPair {
 public:
  BodyPair(Body light_body, Body blocker_body);

  Body light;
  Body blocker;

  /// Side of light corner j of the plane through a, b, c, which run counterclockwise seen from its positive side. Of a
  /// light at infinity the corner is a direction.
  int side_of_light(const Point3& a, const Point3& b, const Point3& c, std::uint32_t j) const {
    return light.at_infinity ? exact_direction_side(a, b, c, light.corners[j])
                             : orientation_(a, b, c, light.corners[j]);
  }
  int orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) const {
    return orientation_(a, b, c, d);
  }

  /// Side of light corner j of a facet of the blocker: +1 in front of it.
  int facet_side(std::uint32_t facet, std::uint32_t j) const { return facet_sides_[facet * light.corners.size() + j]; }

  /// The sides of a facet of the blocker on which corners of the light lie: all of them, or some.
  Sides light_sides(std::uint32_t facet) const;
  Sides light_sides(std::uint32_t facet, const std::vector<std::uint32_t>& corners) const;

  /// The sides of a facet of the light on which corners of the blocker lie.
  Sides blocker_sides(std::uint32_t light_facet) const;

 private:
  OrientationFilter orientation_;
  std::vector<std::int8_t> facet_sides_;
};

}  // namespace gnomon
