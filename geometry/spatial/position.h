#pragma once

#include <string_view>

#include "geometry/spatial/light.h"

namespace gnomon {

/// How a light and a flat blocker stand to each other. The first that holds, in this order, is the pair's position:
/// coplanar, behind_light, both_cross, light_crosses_blocker_plane, blocker_crosses_light_plane, touching, standard.
enum class Position {
  standard,  ///< the light strictly on one side of the blocker's plane, and the blocker strictly in front of an area
             ///< light
  light_crosses_blocker_plane,  ///< the light has points strictly on both sides of the blocker's plane
  blocker_crosses_light_plane,  ///< the blocker has points strictly on both sides of an area light's plane
  both_cross,                   ///< both of these
  touching,      ///< nothing crosses, but the light reaches the blocker's plane, or the blocker the light's
  coplanar,      ///< the light lies in the blocker's plane
  behind_light,  ///< no point of the blocker strictly in front of a one-sided area light
};

/// The position's name as scripts read it.
std::string_view name(Position position);

/// The position of a pair.
///
/// Requires:   light and blocker are flat; the light is not directional.
/// Degenerate: a two-sided area light has two fronts.
/// Exactness:  signs of orientation determinants of input points.
/// Cost:       O(n + m).
/// Throws:     PreconditionError.
Position pair_position(const Light& light, const ConvexPolygon& blocker);

}  // namespace gnomon
