#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "apps/gnomon/point_batches.h"
#include "apps/gnomon/viewed_surface.h"
#include "gnomon/reflection.h"
#include "gnomon/scene.h"

namespace gnomon {

/// A row of the table of views, and the radiance that it sees of each light and of what comes from everywhere.
struct ViewedRow {
  TableRow row;
  ReflectedLights reflected;  ///< none for a malformed row
};

/// Columns of radiances and their bounds: one of each where colours do not differ, else three.
struct RadianceColumns {
  bool coloured = false;

  /// ",radiance,BOUND", with the suffix behind each; or ",radiance_r,BOUND_r" and so on.
  std::string header(const std::string& bound_name, const std::string& suffix) const;
  std::string text(const RadianceRgb& radiance) const;
};

/// Three radiances, and their bounds under another name.
nlohmann::ordered_json radiance_json(const RadianceRgb& radiance, const std::string& bound_name);

/// The result as CSV, row by row: the fields as they were written, then light,radiance,error_bound of each light, of
/// `ambient` and of `total`; where colours differ radiance_r,error_bound_r and so on. Malformed rows are left out.
class RadianceCsv {
 public:
  RadianceCsv(std::ostream& stream, const std::string& header, std::vector<std::string> lights, bool coloured);
  void add(const ViewedRow& seen);

 private:
  void add_line(const std::string& fields, const std::string& light, const RadianceRgb& radiance);

  std::ostream& stream_;
  std::vector<std::string> lights_;  ///< quoted where CSV asks for it
  RadianceColumns columns_;
};

/// The result as JSON of schema gnomon/radiance/1, point by point, of three colours. What is infinite is null.
class RadianceJson {
 public:
  RadianceJson(std::ostream& stream, const SpaceScene& scene, const std::string& material,
               std::vector<std::string> lights);
  void add(const ViewedRow& seen);
  void finish(std::size_t points, std::size_t malformed_lines);

 private:
  std::ostream& stream_;
  std::vector<std::string> lights_;
  bool first_ = true;
};

}  // namespace gnomon
