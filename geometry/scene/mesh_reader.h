#pragma once

#include <filesystem>

#include "geometry/scene/scene_elements.h"
#include "gnomon/scene.h"

namespace gnomon {

/// What a mesh is read for: of blockers and lights it matters whether they are closed and convex.
enum class MeshUse { blocker, receiver, light };

/// Reads the mesh file that an element names, or the mesh that it holds itself. Vertices of equal coordinates become
/// one, in every format.
///
/// Facets have to be simple polygons near a plane; they may have holes, by seams. Doubts are added to the scene: what
/// was mended (see checked_facets) or passed over, lamps among the materials, a mesh that is not closed.
///
/// Throws: SceneError; UnsupportedSceneError for a light that is not closed and convex.
Mesh read_mesh(const SceneElement& element, const std::filesystem::path& folder, SpaceScene& scene,
               MeshUse use = MeshUse::blocker);

}  // namespace gnomon
