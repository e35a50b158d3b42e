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

/// Which files are read. Scenes may come through a pipe that the user has named; what a scene names may be anything.
enum class FileKind {
  any,
  regular,  ///< neither pipes, on which opening may wait for ever, nor devices nor sockets
};

/// Reads a file of at most `limit` bytes. No more than that is ever held, whatever the file claims to be.
FileText file_text(const std::filesystem::path& file, std::size_t limit, FileKind kind = FileKind::any);

}  // namespace gnomon
