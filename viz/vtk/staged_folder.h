#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::viz {

/// A file on its way: written at `temporary`, meant for `target`.
struct StagedFile {
  std::filesystem::path temporary;
  std::filesystem::path target;
};

/// Files that take their places in a folder together. They are written to a hidden folder inside it, which makes
/// renaming possible without copying, and which goes away with this object. What a killed process left there is
/// removed by the next one.
class StagedFolder {
 public:
  /// Throws: std::runtime_error if the folder cannot be made.
  explicit StagedFolder(std::filesystem::path directory);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  /// A place to write the file that is to be `relative` (with '/') to the folder.
  StagedFile add(const std::string& relative);

  /// Writes a whole file. Throws: std::runtime_error.
  void add_text(const std::string& relative, std::string_view text);

  /// Renames the files into place, in the order in which they were added. Throws: std::runtime_error.
  void publish();

  /// All files added, relative to the folder.
  const std::vector<std::string>& files() const { return files_; }

  const std::filesystem::path& directory() const { return directory_; }

 private:
  std::filesystem::path directory_;
  std::filesystem::path staging_;
  std::vector<std::string> files_;
};

/// Removes the hidden folders of all StagedFolders of this process, which is about to end before its time: waits until
/// none of them is renaming files, and lets none begin to from then on. May be called by any thread, and once.
void remove_staging_folders();

}  // namespace gnomon::viz
