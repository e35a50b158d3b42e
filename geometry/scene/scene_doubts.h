#pragma once

#include <string>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {

/// What is allowed in a scene as a whole but looks like a mistake, one sentence each: nothing that blocks, blockers in
/// the same place.
std::vector<std::string> scene_doubts(const SpaceScene& scene);
std::vector<std::string> scene_doubts(const PlaneScene& scene);

/// The same of light and materials: nothing that shines, a light without strength, in a solid, or one that turns its
/// back to every blocker, a receiver that is turned from every light, a material that reflects more than it receives.
std::vector<std::string> lighting_doubts(const SpaceScene& scene);
std::vector<std::string> lighting_doubts(const PlaneScene& scene);

}  // namespace gnomon
