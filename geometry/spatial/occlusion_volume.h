#pragma once

#include <vector>

#include "geometry/spatial/convex_polyhedron.h"
#include "geometry/spatial/pair_half_spaces.h"

namespace gnomon {

/// The half-spaces of the occlusion of a pair in any position: the facets of the blocker that all of the light lies
/// before, the separating planes, and those of the light's facets.
std::vector<HalfSpace> occlusion_half_spaces(const BodyPair& pair, const std::vector<HalfSpace>& light_planes);

/// The occlusion of a pair in standard position, unbounded as it is: B + cone{b - l}.
/// Its corners are the blocker's, its unbounded edges run away from light corners.
///
/// Requires: `corners` are those of standard_corners, `planes` those of standard_half_spaces(pair, contacts).occlusion,
///           in their order; the first one is the downward plane of the space.
/// Cost:     O(n + m).
ConvexPolyhedron standard_occlusion(ExactSpace& space, const StandardPair& pair, const StandardContacts& contacts,
                                    const std::vector<VertexId>& corners, const std::vector<PlaneId>& planes);

}  // namespace gnomon
