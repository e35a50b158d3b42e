#pragma once

#include <vector>

#include "geometry/region.h"
#include "geometry/spatial/closed_surface.h"
#include "geometry/spatial/convex_blocker.h"
#include "geometry/spatial/light.h"

namespace gnomon {

/// Everything that stands between points and lights.
struct Obstacles {
  std::vector<ConvexBlocker> blockers;    ///< their union blocks
  std::vector<ClosedSurface> enclosures;  ///< what a closed mesh encloses; its facets are among the blockers
};

/// What a point receives of a light, without regard to how brightly it shines.
struct Visibility {
  Region region = Region::lit;
  double fraction = 1;     ///< the visible fraction f; 0 where unlit
  double error_bound = 0;  ///< at least |fraction - f|

  friend bool operator==(const Visibility&, const Visibility&) = default;
};

/// What a point sees of a light behind all obstacles together.
///
/// Definition: a point l of the light is hidden if the open segment (p, l), for a directional light the open ray, meets
///             a blocker. f is the share of what is not hidden, by area or length; for a point or a direction 1 or 0.
///             Lit: f = 1. Umbra: f = 0, and every point strictly inside a solid or an enclosure. Unlit: in the plane
///             of an area light or behind a one-sided one; this takes precedence.
/// Degenerate: every position of light, blockers and point. A grazing contact hides point and directional lights, and
///             changes nothing for the others, as it has no area or length. A point on a flat blocker sees both sides.
/// Exactness:  the region is decided in rational arithmetic. `fraction` is the double nearest to f, but where f had to
///             be enclosed (to 2^-190, for lights whose vertices are not exactly coplanar and for more than 64 pieces)
///             it may be a neighbour that is as near up to the enclosure.
/// Cost:       rational arithmetic for every blocker that may reach the light; meant as a reference.
Visibility exact_visibility(const Light& light, const Obstacles& obstacles, const Point3& p);

}  // namespace gnomon
