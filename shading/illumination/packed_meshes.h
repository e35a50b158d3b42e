#pragma once

/// Meshes as bytes, for other processes. Private to the libraries.

#include <cstdint>
#include <span>
#include <vector>

#include "gnomon/illumination.h"

namespace gnomon::illumination {

/// Those of some receivers, but for their order.
std::vector<char> packed(std::span<const IlluminationMesh> meshes, std::span<const std::uint32_t> receivers);

/// The same back again.
///
/// Throws: std::runtime_error if bytes are missing.
void unpack(std::span<const char> bytes, std::span<const std::uint32_t> receivers,
            std::vector<IlluminationMesh>& meshes);

}  // namespace gnomon::illumination
