#pragma once

#include <string>
#include <vector>

#include "apps/gnomon/scene_pairs.h"
#include "gnomon/result.h"

namespace gnomon {

/// What `gnomon shadow` found, for people: a block per pair, or a line per pair if there are many.
///
/// Requires: `result` as computed_shadows returns it for the same pairs.
std::string shadow_summary(const ShadowResult& result, const std::vector<ScenePair>& pairs);

/// The box for people: "x 0 to 1, y 0 to 1, z 0 to 1"; in the plane without z.
std::string box_text(const Box3& box, int dimension);

/// The scene's name, how many elements it has, and its length unit.
std::string scene_text(const Scene& scene);

/// "2 lights, 1 blocker".
std::string lights_and_blockers(const Scene& scene);

/// One warning that names the pairs that are not supported and why; empty if there are none.
std::string unsupported_text(const std::vector<ScenePair>& pairs);

}  // namespace gnomon
