#pragma once

/// What may stand between two flat pieces of surfaces. Private to the libraries.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bodies/box_hierarchy.h"
#include "gnomon/blocker.h"
#include "gnomon/convex_polygon.h"

namespace gnomon::illumination {

/// Finds the blockers that may hide one flat polygon from another.
class StandingBetween {
 public:
  explicit StandingBetween(std::span<const ConvexBlocker> blockers);

  /// Their numbers, ascending: all that hide something, and some that do not. A blocker is left out if a plane parts it
  /// from both polygons, which may touch it: a polygon's own, one of the blocker's, or one that supports both polygons.
  ///
  /// Requires:  the polygons are flat, do not lie in one plane, and each has something before the other.
  /// Exactness: conservative; every plane is tried by exact signs.
  void find(const ConvexPolygon& first, const ConvexPolygon& second, std::vector<std::uint32_t>& found) const;

 private:
  std::span<const ConvexBlocker> blockers_;
  BoxHierarchy boxes_;
};

}  // namespace gnomon::illumination
