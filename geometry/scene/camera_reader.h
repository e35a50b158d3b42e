#pragma once

#include <optional>

#include "geometry/scene/scene_elements.h"
#include "gnomon/scene.h"

namespace gnomon {

/// The key "camera" of a scene; nothing without it.
///
/// Throws: SceneError.
std::optional<SceneCamera> read_camera(const JsonNode& document, UpAxis up);

/// The keys "normals" and "crease" of a mesh.
Smoothness read_smoothness(const SceneElement& element);

}  // namespace gnomon
