#pragma once

#include <vector>

#include "geometry/region.h"
#include "geometry/spatial/closed_surface.h"
#include "geometry/spatial/convex_blocker.h"
#include "geometry/spatial/light.h"
#include "geometry/visibility/receiver_front.h"

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
  /// Of a receiver's point, the share of the light before the receiver's plane: correctly rounded, or for lights that
  /// are not flat next to that. Of a bare point 1.
  double before_receiver = 1;

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

/// What a receiver's point receives of a light behind all obstacles together.
///
/// Definition: of the light counts what lies strictly before the receiver's plane (L+). Unlit: nothing of it, or none
///             that has an area or length, or the light shows its back or edge. Else the limit from the front is meant,
///             from the point moved by e along the receiver's normal, e -> 0. Lit: nothing of L+ is hidden; umbra: all
///             of it, and inside solids and enclosures. f is the visible part of L+ as a share of the whole light. So
///             with lights that emit alike everywhere the irradiance is positive exactly where lit or in penumbra.
/// Degenerate: every position. Blockers wholly in or behind the plane hide nothing, so a plate that is blocker and
///             receiver does not hide the light from itself. A point on an enclosure's surface is not enclosed.
/// Exactness:  as above; nothing is moved, signs that are 0 are decided by how they grow along the normal.
Visibility exact_received(const Light& light, const Obstacles& obstacles, const ReceiverPoint& receiver);

/// True if the point lies strictly inside an enclosure. Of a receiver's point: and none of the enclosure's triangles
/// lies in the receiver's plane, and it rests on none.
bool is_enclosed(const Obstacles& obstacles, const Point3& p);
bool is_enclosed(const Obstacles& obstacles, const ReceiverPoint& receiver);

}  // namespace gnomon
