#pragma once

#include "geometry/bodies/sides.h"
#include "geometry/numbers/orientation.h"
#include "gnomon/light.h"
#include "gnomon/pair.h"

namespace gnomon {

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
