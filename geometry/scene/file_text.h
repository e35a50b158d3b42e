#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace gnomon {

/// The bytes of a file, or why there are none, in words that follow "found": `no such file`, `a folder`.
struct FileText {
  std::string text;
  std::string problem;
};

/// Reads a file of at most `limit` bytes. No more than that is ever held, whatever the file claims to be.
FileText file_text(const std::filesystem::path& file, std::size_t limit);

}  // namespace gnomon
