#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "apps/gnomon/point_batches.h"
#include "apps/gnomon/radiance_output.h"
#include "apps/gnomon/viewed_surface.h"
#include "gnomon/irradiance.h"
#include "gnomon/scene.h"

namespace gnomon {

/// A row of the table of points, and what its receiver gets of each light.
struct LitRow {
  TableRow row;
  std::vector<Irradiance> received;  ///< empty for a malformed row
  ReflectedLights reflected;         ///< none without an eye
  std::array<double, 3> eye{};
};

/// What was worked out of a row, as bytes for other processes; and the same back again.
std::vector<char> packed_results(const LitRow& lit);
void unpack_results(std::span<const char> bytes, LitRow& lit);

/// How the table is laid out. By default it has a row for each point and light.
struct IrradianceLayout {
  bool wide = false;  ///< a row for each point, with two columns for each light
  bool sum = false;   ///< a row for each point, with two columns for all lights together
  /// Behind irradiances and their bounds the same of radiances, where an eye is given; those of the sum count ambient
  /// light too.
  std::optional<RadianceColumns> radiance = {};
};

/// Mean, least and largest irradiance that each light gives, and all together.
struct IrradianceSummaries {
  std::vector<std::string> names;
  std::vector<IrradianceSummary> lights;
  IrradianceSummary sum;

  explicit IrradianceSummaries(const std::vector<std::string>& light_names)
      : names(light_names), lights(light_names.size()) {}
  void add(const LitRow& lit);

  /// A table for people.
  std::string text() const;
};

/// The result as CSV, row by row: the fields as they were written, then light,irradiance,error_bound, or what the
/// layout asks for. Malformed rows are left out.
class IrradianceCsv {
 public:
  IrradianceCsv(std::ostream& stream, const std::string& header, std::vector<std::string> lights,
                const IrradianceLayout& layout);
  void add(const LitRow& lit);

 private:
  std::string column_names(const std::string& suffix) const;
  std::string columns_of(const LitRow& lit, std::size_t light) const;

  std::ostream& stream_;
  std::vector<std::string> lights_;  ///< quoted where CSV asks for it
  IrradianceLayout layout_;
};

/// The result as JSON of schema gnomon/irradiance/1, point by point. What is infinite is null.
class IrradianceJson {
 public:
  /// With radiance in the layout of this material, else its name is empty.
  IrradianceJson(std::ostream& stream, const SpaceScene& scene, std::vector<std::string> lights,
                 const IrradianceLayout& layout, const std::string& material);
  void add(const LitRow& lit);
  void finish(const IrradianceSummaries& summaries, std::size_t malformed_lines);

 private:
  std::ostream& stream_;
  std::vector<std::string> lights_;
  IrradianceLayout layout_;
  bool first_ = true;
};

}  // namespace gnomon
