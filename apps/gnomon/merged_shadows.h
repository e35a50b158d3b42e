#pragma once

#include <vector>

#include "apps/gnomon/computed_shadows.h"
#include "apps/gnomon/scene_pairs.h"
#include "gnomon/result.h"

namespace gnomon {

/// For every light and every blocker of several parts the parts' occlusion volumes as one. A blocker of which a part is
/// not supported is left out.
///
/// Requires: `pairs` are of this scene, of dimension 3, in the order of scene_pairs; the box as in shadow_meshes.
std::vector<MergedResult> merged_shadows(const SpaceScene& scene, const std::vector<ScenePair>& pairs,
                                         const Box3& clip_box, const Effort& effort);

}  // namespace gnomon
