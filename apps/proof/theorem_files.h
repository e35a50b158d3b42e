#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/gnomon/computed_shadows.h"
#include "apps/proof/laws/example.h"

namespace gnomon {

/// Writes an example as `KEY.scene.json`, and its points as `KEY.csv`, into a folder, which is made if need be.
///
/// Returns: the names of the files written, the folder's before them.
/// Throws:  std::runtime_error naming the file and the cause.
std::vector<std::string> write_example(const laws::Example& example, const std::string& key,
                                       const std::filesystem::path& folder);

/// Draws a scene file written by write_example as `KEY.png` beside it, as `gnomon render` does. A scene of which no
/// pair is supported is not drawn.
///
/// Returns: the name of the file, or nothing.
/// Throws:  std::runtime_error; NoDisplayError.
std::vector<std::string> draw_example(const std::string& key, const std::filesystem::path& folder,
                                      const Effort& effort);

}  // namespace gnomon
