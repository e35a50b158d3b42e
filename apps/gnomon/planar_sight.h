#pragma once

#include "geometry/planar/sight.h"
#include "geometry/scene/scene.h"

namespace gnomon {

/// A light of a scene of the plane behind all segments of its blockers together, polylines cut into segments in order.
///
/// Requires: the light is one of the scene's.
planar::Sight planar_sight(const Scene& scene, const PlanarLight& light);

}  // namespace gnomon
