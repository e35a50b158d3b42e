#pragma once

#include <cstddef>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/convex_polygon.h"
#include "gnomon/light.h"

namespace gnomon::report {

/// k x k stacks of 8 boxes on a floor. Each box is turned about the vertical axis by a multiple of 90 degrees plus a
/// twist; its faces are exactly planar. Every face of a box is a receiver, and so is the floor, the first of them.
struct BoxStacks {
  std::vector<ConvexBlocker> boxes;
  std::vector<ConvexPolygon> receivers;
};

BoxStacks box_stacks(std::size_t k);

/// A small hexagonal light, 32 arc minutes wide, azimuth 210 and elevation 65 degrees, a thousand stack pitches away.
/// Its vertices are exactly coplanar.
Light distant_hexagon(std::size_t k);

/// A square light as wide as two stacks, three stack heights above the floor.
Light square_above(std::size_t k);

}  // namespace gnomon::report
