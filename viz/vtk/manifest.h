#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gnomon/errors.h"
#include "viz/vtk/block.h"

namespace gnomon::viz {

/// A block and the files it has been written to, relative to the folder; none if it is empty.
struct WrittenBlock {
  const Block* block;
  std::vector<std::string> files;
  std::string generation;  ///< that the files carry
};

/// What `manifest.json` says, beside the result itself.
struct ManifestEntries {
  std::string command;                   ///< shadow, receivers or discontinuities
  std::vector<std::string> generations;  ///< that the leaves carry: one, or of a series one a time
  std::vector<std::string> roots;        ///< the files to open
  std::vector<std::string> files;        ///< every file of the result but manifest.json
  std::vector<WrittenBlock> blocks;
};

/// A result of another command in the same folder. Its leaves stay; `manifest.json` tells of the last result only, and
/// of the others that they are there.
struct OtherResult {
  std::string command;
  std::string generation;
  std::vector<std::string> roots;
  std::vector<std::string> files;
};

/// The text of `manifest.json`.
std::string manifest_text(const ShadowResult& result, const ManifestEntries& entries);

/// The same text with the other results in its folder.
std::string with_others(const std::string& manifest, const std::vector<OtherResult>& others);

/// A block as a manifest on disk lists it.
struct ListedBlock {
  std::vector<std::string> path;
  std::string kind;
  std::string file;        ///< the block's VTK file relative to the folder; empty if there is none
  std::string generation;  ///< that the file carries; empty if the manifest is older than these
};

struct ListedResult {
  std::string scene;
  int dimension = 3;
  UpAxis up = UpAxis::z;
  std::string length_unit = "m";
  Box3 clip_box;
  bool complete = true;  ///< every pair is supported
  std::vector<ListedBlock> blocks;
};

/// Reads a folder's `manifest.json`. Throws: ResultError naming the file.
ListedResult read_manifest(const std::filesystem::path& directory);

/// The result that a folder's manifest tells of, and those of other commands that it mentions. None if there is no
/// manifest of ours that can be read.
std::vector<OtherResult> results_in_folder(const std::filesystem::path& directory);

/// What a folder holds before a command writes into it.
struct EarlierResults {
  std::vector<std::string> files;  ///< of the same command's last result
  std::vector<OtherResult> others;
};

/// Nothing if there is no manifest of ours that can be read.
EarlierResults earlier_results(const std::filesystem::path& directory, const std::string& command);

}  // namespace gnomon::viz
