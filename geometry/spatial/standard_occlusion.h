#pragma once

#include <vector>

#include "geometry/spatial/convex_polyhedron.h"
#include "geometry/spatial/pair.h"
#include "geometry/spatial/pair_half_spaces.h"

namespace gnomon {

/// The contacts of a pair in standard position.
struct StandardContacts {
  explicit StandardContacts(const StandardPair& pair);

  std::vector<TouchedCorners> separating;     ///< for each blocker side
  std::vector<TouchedCorners> supporting;     ///< for each blocker side
  std::vector<LightSideContact> light_sides;  ///< from separating_light_contacts
};

/// The half-spaces of a pair in standard position, from one walk around both rings.
///
/// Returns: occlusion: the blocker's face, one half-space for each blocker side, those of the light sides in the order
///          of the walk; umbra: the blocker's face, one half-space for each blocker side.
/// Cost:    O(n + m).
PairHalfSpaces standard_half_spaces(const StandardPair& pair, const StandardContacts& contacts);

/// The blocker's corners, in the order of its ring.
std::vector<VertexId> standard_corners(ExactSpace& space, const StandardPair& pair);

/// The occlusion of a pair in standard position, unbounded as it is: B + cone{b - l}.
/// Its corners are the blocker's, its unbounded edges run away from light corners.
///
/// Requires: `corners` are those of standard_corners, `planes` those of standard_half_spaces(pair, contacts).occlusion,
///           in their order; the first one is the downward plane of the space.
/// Cost:     O(n + m).
ConvexPolyhedron standard_occlusion(ExactSpace& space, const StandardPair& pair, const StandardContacts& contacts,
                                    const std::vector<VertexId>& corners, const std::vector<PlaneId>& planes);

/// The umbra of a pair in standard position if none of its sides gets shorter away from the blocker; else empty. A ray
/// leaves each corner of such an umbra, on the planes of both sides there.
///
/// Requires: as for standard_occlusion, with the planes of the umbra.
/// Cost:     O(m).
ConvexPolyhedron standard_umbra(ExactSpace& space, const std::vector<VertexId>& corners,
                                const std::vector<PlaneId>& planes);

}  // namespace gnomon
