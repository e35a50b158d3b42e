#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "apps/gnomon/point_batches.h"
#include "gnomon/reflection.h"
#include "gnomon/scene.h"

namespace gnomon {

/// A row of the table of views, and the radiance that it sees of each light and of what comes from everywhere.
struct SeenRow {
  TableRow row;
  std::vector<RadianceRgb> lights;  ///< empty for a malformed row
  RadianceRgb ambient;

  RadianceRgb total() const;
};

/// The result as CSV, row by row: the fields as they were written, then light,radiance,error_bound of each light, of
/// `ambient` and of `total`; where colours differ radiance_r,error_bound_r and so on. Malformed rows are left out.
class RadianceCsv {
 public:
  RadianceCsv(std::ostream& stream, const std::string& header, std::vector<std::string> lights, bool coloured);
  void add(const SeenRow& seen);

 private:
  void add_line(const std::string& fields, const std::string& light, const RadianceRgb& radiance);

  std::ostream& stream_;
  std::vector<std::string> lights_;  ///< quoted where CSV asks for it
  std::size_t channels_;
};

/// The result as JSON of schema gnomon/radiance/1, point by point, of three colours. What is infinite is null.
class RadianceJson {
 public:
  RadianceJson(std::ostream& stream, const SpaceScene& scene, const std::string& material,
               std::vector<std::string> lights);
  void add(const SeenRow& seen);
  void finish(std::size_t points, std::size_t malformed_lines);

 private:
  std::ostream& stream_;
  std::vector<std::string> lights_;
  bool first_ = true;
};

}  // namespace gnomon
