#pragma once

#include "geometry/numbers/orientation.h"
#include "gnomon/light.h"
#include "gnomon/pair.h"

namespace gnomon {

/// On which sides of a plane a set of points lies.
struct Sides {
  bool positive = false;
  bool zero = false;
  bool negative = false;

  void add(int sign) {
    positive = positive || sign > 0;
    zero = zero || sign == 0;
    negative = negative || sign < 0;
  }
  bool cross() const { return positive && negative; }
  bool all_zero() const { return !positive && !negative; }
};

/// Where the light's points lie beside the blocker's plane, and the blocker's beside the plane of an area light (no
/// sides for other lights); and the filter for all points of the pair that found it out.
struct PairSides {
  Sides light;
  Sides blocker;
  OrientationFilter orientation;
};

/// Requires:  light and blocker are flat; the light is not directional.
/// Exactness: signs of orientation determinants of input points.
/// Cost:      O(n + m).
/// Throws:    PreconditionError.
PairSides pair_sides(const Light& light, const ConvexPolygon& blocker);

/// Requires: `sides` is pair_sides(light, blocker) for some blocker.
Position pair_position(const Light& light, const PairSides& sides);

}  // namespace gnomon
