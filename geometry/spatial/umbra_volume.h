#pragma once

#include <vector>

#include "geometry/spatial/convex_polyhedron.h"
#include "geometry/spatial/light_contact.h"
#include "geometry/spatial/pair_half_spaces.h"

namespace gnomon {

/// True if the umbra of a pair in any position has an interior.
bool has_umbra(const BodyPair& pair, const LightContact& contact);

/// Its half-spaces: the facets of the blocker that a corner of the light outside of it sees or that part of the light
/// lies in, the supporting planes, and those of the light's facets.
std::vector<HalfSpace> umbra_half_spaces(const BodyPair& pair, const LightContact& contact,
                                         const std::vector<HalfSpace>& light_planes);

/// The umbra of a pair in standard position if none of its sides gets shorter away from the blocker; else empty. A ray
/// leaves each corner of such an umbra, on the planes of both sides there.
///
/// Requires: as for standard_occlusion, with the planes of the umbra.
/// Cost:     O(m).
ConvexPolyhedron standard_umbra(ExactSpace& space, const std::vector<VertexId>& corners,
                                const std::vector<PlaneId>& planes);

}  // namespace gnomon
