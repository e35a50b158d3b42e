#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "viz/vtk/manifest.h"
#include "viz/vtk/staged_folder.h"

namespace gnomon::viz {

/// Puts a result into its folder: the staged files, then `manifest.json`; then those files of the same command's
/// earlier result go that were not written again. Results of other commands stay, and so does what is not ours. Only
/// one process does this at a time.
///
/// Requires: all files but the manifest are staged; `manifest` is its text.
/// Returns:  every file written, relative to the folder, the roots first.
/// Throws:   std::runtime_error naming the file that could not be written or is not ours; nothing is replaced then,
///           unless the system refuses to rename a file.
std::vector<std::filesystem::path> publish_result(StagedFolder& folder, const std::string& manifest,
                                                  const std::string& command, const std::vector<std::string>& roots);

/// The text of view.py, the ParaView script that lies beside every result.
std::string_view view_script();

}  // namespace gnomon::viz
