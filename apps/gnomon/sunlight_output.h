#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "apps/gnomon/point_table.h"
#include "gnomon/scene.h"
#include "gnomon/sunlight.h"

namespace gnomon {

/// A point of the table, and when the sun shines on it.
struct SunlitRow {
  PointRow row;
  SunlitDay day;
};

/// Rows of CSV: the input's fields, then hours,error_bound,intervals.
void write_sunlight_rows(std::ostream& stream, std::span<const SunlitRow> rows);

/// The JSON of `gnomon sunlight`, schema gnomon/sunlight/1. `parts` are the names of the obstacles.
nlohmann::ordered_json sunlight_json(const SpaceScene& scene, const SunDay& day, std::span<const SunlitRow> rows,
                                     const std::vector<std::string>& parts);

}  // namespace gnomon
