#pragma once

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "apps/gnomon/point_table.h"
#include "gnomon/scene.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// A row of the table of points, and what its point receives of each light.
struct JudgedRow {
  std::variant<PointRow, MalformedRow> row;
  std::vector<Visibility> seen;     ///< empty for a malformed row
  bool is_within_rounding = false;  ///< rounding may have put the point on the wrong side of a blocker
};

/// Whether the points are bare or those of receivers, with a side.
enum class PointKind { bare, of_receivers };

/// How many points are in which region of each light.
class RegionCounts {
 public:
  explicit RegionCounts(std::vector<std::string> lights) : lights_(std::move(lights)), counts_(lights_.size()) {}

  void add(const JudgedRow& judged);

  const std::vector<std::string>& lights() const { return lights_; }
  std::size_t count(std::size_t light, Region region) const { return counts_[light][std::size_t(region)]; }
  std::size_t points() const { return points_; }
  std::size_t malformed_lines() const { return malformed_lines_; }

  /// A table for people.
  std::string text() const;

 private:
  std::vector<std::string> lights_;
  std::vector<std::array<std::size_t, 4>> counts_;
  std::size_t points_ = 0;
  std::size_t malformed_lines_ = 0;
};

/// The result as CSV, row by row: the fields as they were written, then light,region,visible_fraction,error_bound; of
/// receivers' points before_receiver too. Malformed rows are left out.
class RegionsCsv {
 public:
  RegionsCsv(std::ostream& stream, const std::string& header, std::vector<std::string> lights, PointKind kind);
  void add(const JudgedRow& judged);

 private:
  PointKind kind_;
  std::ostream& stream_;
  std::vector<std::string> lights_;  ///< quoted where CSV asks for it
};

/// The result as JSON of schema gnomon/regions/1, point by point.
class RegionsJson {
 public:
  RegionsJson(std::ostream& stream, const Scene& scene, std::vector<std::string> lights, PointKind kind);
  void add(const JudgedRow& judged);
  void finish(const RegionCounts& counts);

 private:
  std::ostream& stream_;
  std::vector<std::string> lights_;
  int dimension_;
  PointKind kind_;
  bool first_ = true;
};

}  // namespace gnomon
