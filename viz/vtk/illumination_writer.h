#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/illumination.h"
#include "gnomon/scene.h"
#include "gnomon/writer.h"

namespace gnomon {

/// One side of a receiver as its meshes, one of each flat piece.
struct IlluminatedSide {
  std::string name;
  std::vector<const IlluminationMesh*> pieces;
  std::optional<Rgb> diffuse = {};  ///< what share of the irradiance it reflects diffusely; nothing without a material
};

struct IlluminationResult {
  const Scene* scene = nullptr;  ///< never null when used; outlives the result
  Box3 clip_box;
  std::vector<std::string> lights;
  std::vector<IlluminatedSide> sides;
  double tolerance = 0;  ///< [W/m²]
  int order = 1;
};

/// Writes a tree `illumination.{vtm,vtpc}` with the scene and, of every side, `illumination/SIDE` and
/// `illumination_edges/SIDE`. Faces have the point arrays irradiance, irradiance_bound, irradiance_LIGHT and, with a
/// material, radiosity_direct, and the cell arrays error, unmet and face_id; lines have discontinuity_order.
///
/// Returns: the files written, relative to the folder, those to be opened by a user first.
/// Throws:  as write_shadow.
std::vector<std::filesystem::path> write_illumination(const IlluminationResult& result,
                                                      const std::filesystem::path& directory,
                                                      const std::vector<OutputFormat>& formats);

}  // namespace gnomon
