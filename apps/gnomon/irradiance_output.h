#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "apps/gnomon/point_batches.h"
#include "geometry/scene/scene.h"
#include "shading/irradiance.h"

namespace gnomon {

/// A row of the table of points, and what its receiver gets of each light.
struct LitRow {
  TableRow row;
  std::vector<Irradiance> received;  ///< empty for a malformed row
};

/// The result as CSV, row by row: the fields as they were written, then light,irradiance,error_bound. Malformed rows
/// are left out.
class IrradianceCsv {
 public:
  IrradianceCsv(std::ostream& stream, const std::string& header, std::vector<std::string> lights);
  void add(const LitRow& lit);

 private:
  std::ostream& stream_;
  std::vector<std::string> lights_;  ///< quoted where CSV asks for it
};

/// The result as JSON of schema gnomon/irradiance/1, point by point. What is infinite is null.
class IrradianceJson {
 public:
  IrradianceJson(std::ostream& stream, const Scene& scene, std::vector<std::string> lights);
  void add(const LitRow& lit);
  void finish(std::size_t points, std::size_t malformed_lines);

 private:
  std::ostream& stream_;
  std::vector<std::string> lights_;
  bool first_ = true;
};

}  // namespace gnomon
