#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/gnomon/scene_pairs.h"
#include "gnomon/result.h"

namespace gnomon {

/// Light, blocker, position (null where none is defined), whether it is supported, and the reason if it is not.
nlohmann::ordered_json pair_json(const ScenePair& pair);

/// The sides of a box, as --box takes them: xmin, ymin, zmin, xmax, ymax, zmax; in the plane without z.
nlohmann::ordered_json box_json(const Box3& box, int dimension);

/// The document of schema gnomon/shadow/1. Numbers are written so that they read back as the same doubles.
///
/// Requires: `result` as computed_shadows returns it for the same pairs; or, where no pair is supported, one that holds
///           the scene and the box alone.
nlohmann::ordered_json shadow_json(const ShadowResult& result, const std::vector<ScenePair>& pairs);

/// Writes the document to the file, or to stdout if it is called "-".
///
/// Throws: std::runtime_error.
void write_json(const nlohmann::ordered_json& document, const std::string& file);

}  // namespace gnomon
