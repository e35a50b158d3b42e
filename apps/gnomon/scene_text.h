#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gnomon/scene.h"

namespace gnomon {

/// The document of a scene file: reading it gives the same scene again. Numbers read back as the same doubles.
///
/// Requires: blockers other than meshes, which are files of their own.
/// Throws:   PreconditionError.
nlohmann::ordered_json scene_document(const Scene& scene);

}  // namespace gnomon
