#pragma once

#include <filesystem>
#include <string>

namespace gnomon {

/// A folder of its own for a test; it goes away with this object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// The whole file; empty if there is none.
std::string file_text(const std::filesystem::path& file);

void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace gnomon
