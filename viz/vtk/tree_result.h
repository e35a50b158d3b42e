#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "gnomon/writer.h"
#include "viz/vtk/block.h"

namespace gnomon::viz {

/// Writes a result of blocks alone into its folder: the blocks' files, a root `COMMAND.vtm` or `COMMAND.vtpc` of each
/// format, the manifest and view.py. `frame` has the scene and the clip box.
///
/// Returns: the files written, relative to the folder, those to be opened by a user first.
/// Throws:  as publish_result.
std::vector<std::filesystem::path> write_tree(std::span<const Block> blocks, const ShadowResult& frame,
                                              const std::string& command, const std::filesystem::path& directory,
                                              std::span<const OutputFormat> formats);

}  // namespace gnomon::viz
