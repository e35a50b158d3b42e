#pragma once

#include <filesystem>

#include "geometry/scene/scene.h"
#include "geometry/scene/scene_elements.h"

namespace gnomon {

/// Reads the mesh file that an element names. Vertices of equal coordinates become one, in every format.
///
/// Every facet is held to the rules of a concave polygon: at least 3 vertices, none repeated, not all on one line,
/// coplanar up to rounding, simple. Doubts (rounded facets, a mesh that is not closed) are added to the scene.
///
/// Throws: SceneError.
Mesh read_mesh(const SceneElement& element, const std::filesystem::path& folder, Scene& scene);

}  // namespace gnomon
