#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "viz/shadow_result.h"

namespace gnomon {

/// Results of one scene over time, in a folder: `shadow.pvd`, which ParaView plays, one `shadow_0000/shadow.vtm` per
/// time with the blocks of write_shadow, `manifest.json` and `view.py`. The manifest lists every block that any time
/// has, with the file of the first time that has it.
///
/// All files are written beside their places and renamed together in `publish`, as write_shadow does.
class SeriesWriter {
 public:
  /// Throws: std::runtime_error if the folder cannot be made.
  explicit SeriesWriter(std::filesystem::path directory);
  ~SeriesWriter();
  SeriesWriter(const SeriesWriter&) = delete;
  SeriesWriter& operator=(const SeriesWriter&) = delete;

  /// Adds the result of a time, which is later than the one before.
  ///
  /// Requires: result.scene is not null; of the same elements and the same clip box as the results before.
  /// Throws:   std::runtime_error naming the file that could not be written; PreconditionError.
  void add(double time, const ShadowResult& result);

  /// Returns: the files written, relative to the folder, the one to be opened by a user first.
  /// Throws:  std::runtime_error naming the file that could not be written; PreconditionError if nothing was added.
  std::vector<std::filesystem::path> publish();

 private:
  struct Writing;
  std::unique_ptr<Writing> writing_;
};

}  // namespace gnomon
