#pragma once

#include <filesystem>
#include <vector>

#include "gnomon/writer.h"
#include "viz/vtk/discontinuity_result.h"

namespace gnomon {

/// Which of the two results is written, and its root's stem: `receivers.vtm`, `discontinuities.vtm`.
enum class DiscontinuityOutput { receivers, discontinuities };

/// Writes a result into a folder as write_shadow does: block files, a root of each format (vtm, vtpc), `manifest.json`
/// and `view.py`. Blocks: `scene/...`, `receivers/LIGHT/RECEIVER/{faces,edges}`, `discontinuities/LIGHT/{d0,d1,d2}`.
///
/// Requires: result.scene is not null; no other formats.
/// Returns:  the files written, relative to the folder, those to be opened by a user first.
/// Throws:   std::runtime_error naming the file that could not be written, and why; PreconditionError.
std::vector<std::filesystem::path> write_discontinuities(const DiscontinuityResult& result, DiscontinuityOutput output,
                                                         const std::filesystem::path& directory,
                                                         const std::vector<OutputFormat>& formats);

}  // namespace gnomon
