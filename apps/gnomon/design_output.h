#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gnomon/light_design.h"
#include "gnomon/writer.h"

namespace gnomon {

/// What a goals file asked for, and what came out.
struct SolvedDesign {
  const SpaceScene& scene;
  const Design& design;
  const DesignObstacles& obstacles;
  const DesignResult& result;
  bool is_check = false;  ///< of one given position alone
};

/// The JSON of `gnomon place`, schema gnomon/place/1.
nlohmann::ordered_json design_json(const SolvedDesign& solved);

/// The same for people.
std::string design_text(const SolvedDesign& solved);

/// What the files show. Cells that are unbounded are left out; `left_out` counts them.
DrawnDesign drawn_design(const SolvedDesign& solved, std::size_t& left_out);

/// "(7.5, 3, 24)"; of a scale "7.5".
std::string position_text(const Design& design, const Point3& position);

}  // namespace gnomon
