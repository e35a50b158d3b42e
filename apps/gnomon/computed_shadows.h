#pragma once

#include <vector>

#include "apps/gnomon/scene_pairs.h"
#include "gnomon/result.h"

namespace gnomon {

/// How to go about a long computation.
struct Effort {
  unsigned threads = 0;        ///< 0: one per processor
  bool shows_progress = true;  ///< on a terminal; nothing is shown elsewhere
};

/// The shadows of the supported pairs; result.pairs (planar_pairs in the plane) has the order of `pairs`,
/// unsupported ones included.
///
/// Requires: `pairs` are of this scene, which outlives the result; the box as in shadow_meshes.
ShadowResult computed_shadows(const Scene& scene, const std::vector<ScenePair>& pairs, const Box3& clip_box,
                              const Effort& effort);

}  // namespace gnomon
