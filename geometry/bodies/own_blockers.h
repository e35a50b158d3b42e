#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "gnomon/blocker.h"

namespace gnomon {

/// Which thin solids have the corners of a facet among their vertices: they stand for facets whose vertices are not
/// exactly coplanar, and must not hide the light from them.
class OwnBlockers {
 public:
  explicit OwnBlockers(std::span<const ConvexBlocker> blockers);

  /// Their indices, ascending.
  std::vector<std::uint32_t> of(const ConvexPolygon& facet) const;

 private:
  using Place = std::array<double, 3>;
  std::map<Place, std::vector<std::uint32_t>> solids_at_;  ///< ascending
};

}  // namespace gnomon
