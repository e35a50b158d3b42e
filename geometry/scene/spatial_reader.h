#pragma once

#include <filesystem>
#include <vector>

#include "geometry/scene/scene_elements.h"
#include "gnomon/scene.h"

namespace gnomon {

/// The elements of a scene of space, checked. Doubts about single elements are added to the scene as they come up.
///
/// Throws: SceneError.
void read_spatial_lights(const std::vector<SceneElement>& elements, const std::filesystem::path& folder,
                         SpaceScene& scene);

/// Mesh files are looked up in `folder`.
void read_spatial_receivers(const std::vector<SceneElement>& elements, const std::filesystem::path& folder,
                            SpaceScene& scene);
void read_spatial_blockers(const std::vector<SceneElement>& elements, const std::filesystem::path& folder,
                           SpaceScene& scene);

}  // namespace gnomon
