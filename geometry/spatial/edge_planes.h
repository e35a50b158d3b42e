#pragma once

#include <vector>

#include "geometry/spatial/body_pair.h"
#include "gnomon/shadow_volume.h"

namespace gnomon {

/// The planes through blocker edges that separate the blocker from the light, other than planes of facets.
///
/// Orientation: the blocker on the negative side, the light on the positive one, both closed.
/// Returns:     none, one or two for every edge, in the order of the edges.
/// Degenerate:  where several light vertices touch, the lowest index is named; vertices on the edge's line count for
///              nothing.
/// Requires:    light and blocker not in one plane.
/// Exactness:   signs of orientation determinants of input points.
/// Cost:        O(edges * light corners).
std::vector<HalfSpace> separating_blocker_planes(const BodyPair& pair);

/// The planes through light edges that separate the two and touch the blocker in one corner, other than the light's own
/// planes. Orientation and degenerate cases as above.
std::vector<HalfSpace> separating_light_planes(const BodyPair& pair);

/// The planes through silhouette edges of the blocker that have the blocker and all of the given light corners on the
/// closed negative side: for every edge between a facet that some of them see and one that they all lie strictly
/// behind.
///
/// Requires: `corners` are corners of the light outside the blocker.
std::vector<HalfSpace> supporting_blocker_planes(const BodyPair& pair, const std::vector<std::uint32_t>& corners);

}  // namespace gnomon
