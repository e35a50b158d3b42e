#pragma once

#include <string>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {

/// What is allowed in a scene as a whole but looks like a mistake, one sentence each: nothing that shines or blocks, a
/// light without strength, blockers in the same place, a light that turns its back to every blocker, a
/// receiver that is turned from every light.
std::vector<std::string> scene_doubts(const SpaceScene& scene);
std::vector<std::string> scene_doubts(const PlaneScene& scene);

}  // namespace gnomon
