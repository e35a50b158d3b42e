#pragma once

#include <optional>

#include "geometry/spatial/pair_half_spaces.h"

namespace gnomon {

/// What is known of the occlusion, the umbra and the penumbra of a pair as wholes.
struct VolumeExtents {
  VolumeFacts occlusion;
  VolumeFacts umbra;
  VolumeFacts penumbra;
  std::uint32_t umbra_pockets = 0;  ///< connected pieces of the umbra outside a solid
};

/// Definition: the umbra is bounded if its exact polyhedron has no corner at infinity. Components of the interior of
///             the occlusion without the umbra: as both are convex, each reaches one connected piece of the umbra's
///             boundary inside the occlusion; of the umbra without a solid: as many as there are connected pieces of
///             the solid's boundary inside the umbra. A light that crosses the plane of a flat blocker makes two.
/// Exactness:  exact throughout.
VolumeExtents volume_extents(const BodyPair& pair, const PairHalfSpaces& half_spaces);

/// A facet of the blocker that light corner j sees from its front, or nothing: it is a point of the blocker.
std::optional<std::uint32_t> facet_seen(const BodyPair& pair, std::uint32_t j);

}  // namespace gnomon
