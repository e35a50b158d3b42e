#pragma once

/// What of a folder is ours to touch: folders of results hold files of others too, and may come from anywhere.

#include <filesystem>
#include <string>

namespace gnomon::viz {

/// Why a file, named relative to a folder, must neither be read nor written: its name leads out of the folder, or a
/// link or something else that is no folder stands on the way to it. Empty if nothing is wrong; the file itself need
/// not be there.
std::string way_out(const std::filesystem::path& directory, const std::filesystem::path& relative);

/// Whether a file says of itself that gnomon wrote it: a manifest by its schema, view.py and tables of blocks by their
/// first lines, block files by the names of their field arrays. Links and what is no regular file say nothing.
bool says_it_is_ours(const std::filesystem::path& file);

/// Whether a result of ours may have a file of that name, relative to its folder.
bool may_be_ours(const std::filesystem::path& relative);

}  // namespace gnomon::viz
