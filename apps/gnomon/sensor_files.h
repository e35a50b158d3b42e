#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/gnomon/irradiance_output.h"
#include "apps/gnomon/output_file.h"

namespace gnomon {

/// Names of the files of daylight tools; empty ones are not written.
struct SensorFileNames {
  std::string sensors;  ///< x y z nx ny nz of a point a line, as daylight tools read and write points
  std::string values;   ///< the irradiance of all lights together, in the order of the points
};

/// Refuses names that mean something else, files that are read, and two that are one, other results among them.
///
/// Throws: UsageError.
void require_sensor_places(const SensorFileNames& names, const std::vector<std::string>& read,
                           const std::vector<std::string>& other_results);

/// Points and results as text, a line each, in one order; malformed rows are in neither. Numbers are the shortest that
/// read back as the same doubles.
class SensorFiles {
 public:
  /// Throws: std::runtime_error naming the file and the cause.
  explicit SensorFiles(const SensorFileNames& names);

  void add(const LitRow& lit);
  void publish();

 private:
  std::optional<OutputFile> sensors_, values_;
};

}  // namespace gnomon
