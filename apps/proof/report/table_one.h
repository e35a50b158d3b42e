#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/proof/report/stopwatch.h"
#include "apps/proof/report/visibility_tasks.h"

namespace gnomon::report {

/// A row of Table I of [PA90] and [P93]: pictures of a primitive above a floor under a linear light, and under l points
/// in its place.
struct TableOneRow {
  std::string primitive;
  bool has_shadows = false;
  double pixel_seconds = 0;  ///< of the picture under the linear light
  /// The time under l points over that under the light is constant + per_point l.
  double constant = 0, per_point = 0;
  double rms = 0;  ///< of the picture under as many points as cost as much, as a share of its largest radiance
  /// How many points bring that down to 1/256 and to 1/1000: between numbers tried, on logarithmic scales, or beyond
  /// the most that were tried on the line through the last two.
  double points_at_256 = 0, points_at_1000 = 0;
  std::uint32_t most_tried = 0;

  /// How many points cost as much as the light.
  double equal() const { return (1 - constant) / per_point; }
};

/// What the papers print for a primitive: constant, per point, equal.
struct PrintedRow {
  std::string primitive;
  bool has_shadows = false;
  double constant = 0, per_point = 0, equal = 0;
};

/// Square, cube, sphere, disk and patch, 1 above a floor, with n = 64 and 32 on the floor; the light is 10 long, 5
/// above them. `alone` nothing is hidden. One thread; `gnomon image`'s way, rays from the eye included.
std::vector<TableOneRow> table_one(Effort effort);

/// What the picture of the sphere with shadows takes under the linear light, so many pixels wide and high.
Seconds sphere_picture(std::uint32_t side);

/// The papers' Table I.
const std::vector<PrintedRow>& printed_table_one();

/// Both as a section of the report.
std::string table_one_section(const std::vector<TableOneRow>& rows);

}  // namespace gnomon::report
