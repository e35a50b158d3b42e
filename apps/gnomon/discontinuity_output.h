#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gnomon/writer.h"

namespace gnomon {

/// The formats of a list like "vtm,vtpc".
///
/// Throws: UsageError for any other format.
std::vector<OutputFormat> tree_formats(const std::string& list);

/// What the user is told of the files written into a folder; nothing if there are none.
std::string written_files_text(const std::string& folder, const std::vector<std::filesystem::path>& files);

}  // namespace gnomon
