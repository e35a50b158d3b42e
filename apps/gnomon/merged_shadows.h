#pragma once

#include <vector>

#include "apps/gnomon/computed_shadows.h"
#include "apps/gnomon/scene_pairs.h"
#include "gnomon/result.h"

namespace gnomon {

/// What is united: the parts of each blocker, or of all blockers.
enum class Merging { each_blocker, all_blockers };

/// For every light and every blocker of several parts, or all blockers, the parts' occlusion volumes as one. What has a
/// part that is not supported is left out.
///
/// Requires: `pairs` are of this scene, of dimension 3, in the order of scene_pairs; the box as in shadow_meshes.
std::vector<MergedResult> merged_shadows(const SpaceScene& scene, const std::vector<ScenePair>& pairs, Merging merging,
                                         const Box3& clip_box, const Effort& effort);

}  // namespace gnomon
