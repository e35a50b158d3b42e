#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gnomon::viz {

/// Removes those of an earlier result's files that are not among the new ones, and the folders that this leaves empty.
/// Only what can be a file of ours inside the folder, and says it is: an earlier manifest is no reason to remove
/// anything else.
void remove_stale(const std::filesystem::path& directory, const std::vector<std::string>& earlier,
                  const std::vector<std::string>& now);

}  // namespace gnomon::viz
