#pragma once

#include <string_view>

#include "geometry/spatial/convex_blocker.h"
#include "geometry/spatial/light.h"

namespace gnomon {

/// How a light and a blocker stand to each other. The first that holds, in this order, is the pair's position:
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
/// Definition: for a solid (or a light whose vertices were rounded off their plane) the hulls take the place of the
///             polygons: the light crosses the blocker if it has a point strictly inside; it touches a solid if it has
///             none there, but one on its boundary.
/// Degenerate: a two-sided area light has two fronts. A directional light is in standard position, or coplanar with a
///             flat blocker whose plane its rays run along.
/// Exactness:  signs of orientation determinants of input points; exact arithmetic where a light meets a solid.
/// Cost:       O(n + m) for flat polygons.
Position pair_position(const Light& light, const ConvexBlocker& blocker);

/// False for the one kind of pair whose shadow is not that of the hulls: a light whose vertices were rounded off their
/// plane, unless the plane of one of its hull's facets, or of the blocker's, holds the two strictly apart, and the
/// blocker lies strictly in front of a one-sided one.
bool is_supported(const Light& light, const ConvexBlocker& blocker);

}  // namespace gnomon
