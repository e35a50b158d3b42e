#pragma once

#include <filesystem>
#include <string_view>

namespace gnomon {

/// Writes the whole text beside the file and renames it, so that the file's old content survives whatever fails.
/// Devices and pipes are written directly.
///
/// Throws: std::runtime_error naming the file and the cause.
void write_output_file(const std::filesystem::path& file, std::string_view text);

}  // namespace gnomon
