#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viz/block.h"

namespace gnomon::viz {

/// A block and the files it has been written to, relative to the folder; none if it is empty.
struct WrittenBlock {
  const Block* block;
  std::vector<std::string> files;
};

/// What `manifest.json` says, beside the result itself.
struct ManifestEntries {
  std::vector<std::string> roots;  ///< the files to open
  std::vector<std::string> files;  ///< every file of the result but manifest.json
  std::vector<WrittenBlock> blocks;
};

/// The text of `manifest.json`.
std::string manifest_text(const ShadowResult& result, const ManifestEntries& entries);

/// A block as a manifest on disk lists it.
struct ListedBlock {
  std::vector<std::string> path;
  std::string kind;
  std::string file;  ///< the block's VTK file relative to the folder; empty if there is none
};

struct ListedResult {
  std::string scene;
  int dimension = 3;
  Box3 clip_box;
  bool complete = true;  ///< every pair is supported
  std::vector<ListedBlock> blocks;
};

/// Reads a folder's `manifest.json`. Throws: std::runtime_error naming the file.
ListedResult read_manifest(const std::filesystem::path& directory);

/// The files that an earlier result in the folder has written; none if there is no manifest that can be read.
std::vector<std::string> earlier_files(const std::filesystem::path& directory);

}  // namespace gnomon::viz
