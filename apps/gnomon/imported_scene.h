#pragma once

#include <array>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "apps/gnomon/imported_model.h"

namespace gnomon {

/// How models become a scene.
struct ImportChoice {
  std::string unit = "m", up = "z";
  std::map<std::string, double> lights;  ///< radiance by the title of a material, above 0
  std::set<std::string> receivers;       ///< titles of materials
  bool merges_coplanar = false;          ///< facets of lamps that lie in one plane are joined: joined_facets
};

/// The scene of some models, and what became of them.
struct ImportedScene {
  std::string text;  ///< one element a line
  std::size_t lights = 0, blockers = 0, receivers = 0;
  std::size_t joined = 0, joined_to = 0;  ///< facets of lamps that were joined, and the lights that they became
};

/// Writes the scene. Facets of materials that emit are polygon lights. Of the others there is one blocker for each
/// material, a mesh that names the model's file, or in models that are no meshes one polygon for each facet.
///
/// `mesh_files`: of each model, how the scene calls its file.
/// Throws: UsageError where a receiver's material emits.
ImportedScene imported_scene(const std::vector<ImportedModel>& models, const std::vector<std::string>& mesh_files,
                             const ImportChoice& choice);

}  // namespace gnomon
