#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "viz/vtk/staged_folder.h"

namespace gnomon {

/// Writes the whole text beside the file and renames it, so that the file's old content survives whatever fails.
/// Devices and pipes are written directly.
///
/// Throws: std::runtime_error naming the file and the cause.
void write_output_file(const std::filesystem::path& file, std::string_view text);

/// A file that is written piece by piece and takes its place when it is complete: the old content survives whatever
/// fails. Devices and pipes are written directly.
class OutputFile {
 public:
  /// Throws: std::runtime_error naming the file and the cause.
  explicit OutputFile(std::filesystem::path file);

  std::ostream& stream() { return stream_; }

  /// Throws: std::runtime_error if anything written was lost, or the file cannot take its place.
  void publish();

 private:
  std::filesystem::path file_;
  std::optional<viz::StagedFolder> folder_;  ///< none for devices and pipes
  std::ofstream stream_;
};

}  // namespace gnomon
