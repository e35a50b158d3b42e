#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/gnomon/command_line.h"

namespace gnomon {

/// What `gnomon shadow --path` wrote.
struct WrittenSeries {
  std::size_t steps = 0;
  std::size_t unsupported_pairs = 0;  ///< of all steps together
  std::vector<std::filesystem::path> files;
};

/// Moves one light of a scene along a path and writes the shadows of every place as a series, times 0, 1, 2, ...; what
/// is cut is cut by one box: the one asked for, or the least that holds the default boxes of all places.
///
/// Throws: as read_light_path and with_light_at; UsageError if --light does not name one light where there are several;
///         UnsupportedError if no pair of any place is supported.
WrittenSeries write_shadow_series(const Scene& scene, const CommonOptions& options, const std::string& path,
                                  const std::string& out);

}  // namespace gnomon
