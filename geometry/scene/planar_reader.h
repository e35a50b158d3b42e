#pragma once

#include <vector>

#include "geometry/scene/scene_elements.h"
#include "gnomon/scene.h"

namespace gnomon {

/// The elements of a scene of the plane, checked.
///
/// Throws: SceneError.
std::vector<PlanarLight> read_planar_lights(const std::vector<SceneElement>& elements);

/// Segments and polylines: blockers, or receivers.
std::vector<PlanarBlocker> read_planar_chains(const std::vector<SceneElement>& elements);

}  // namespace gnomon
