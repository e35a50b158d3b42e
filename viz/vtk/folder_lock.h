#pragma once

#include <filesystem>

namespace gnomon::viz {

/// Keeps other gnomons from putting results into a folder while this object lives. Nothing is left in the folder, and
/// the lock goes with its process, however that ends. On file systems that know no locks it does nothing.
class FolderLock {
 public:
  /// Waits a few seconds where another process holds the folder.
  ///
  /// Throws: std::runtime_error if that process does not come to an end.
  explicit FolderLock(const std::filesystem::path& directory);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace gnomon::viz
