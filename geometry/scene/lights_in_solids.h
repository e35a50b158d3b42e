#pragma once

#include <span>
#include <string>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {

/// The lights of the file, each as its parts.
std::vector<std::span<const SceneLight>> light_elements(std::span<const SceneLight> lights);

/// One sentence for each light that reaches into a solid or a closed mesh, lies on a solid and shines into it, or lies
/// on a flat blocker but for rounding.
void doubt_lights_in_solids(const SpaceScene& scene, std::vector<std::string>& doubts);

}  // namespace gnomon
