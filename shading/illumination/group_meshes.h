#pragma once

/// Meshes as users get them. Private to the libraries.

#include <cstdint>
#include <span>
#include <vector>

#include "gnomon/illumination.h"
#include "shading/illumination/refinement.h"

namespace gnomon::illumination {

/// Fills in the mesh of each receiver of one group, and asks for what each light gives to its points.
void write_meshes(const Refinement& refined, LightsTogether& lights, unsigned threads,
                  std::span<const std::uint32_t> receivers, std::vector<IlluminationMesh>& meshes);

}  // namespace gnomon::illumination
