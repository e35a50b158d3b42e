#include "geometry/bodies/own_blockers.h"

#include <algorithm>

#include "geometry/bodies/plate.h"

namespace gnomon {
OwnBlockers::OwnBlockers(std::span<const ConvexBlocker> blockers) {
  for (std::uint32_t b = 0; b < blockers.size(); ++b) {
    const auto* solid = std::get_if<ConvexSolid>(&blockers[b]);
    if (!solid || plate_ring(*solid).empty()) continue;
    for (const Point3& p : solid->points()) {
      std::vector<std::uint32_t>& solids = solids_at_[{p.x + 0.0, p.y + 0.0, p.z + 0.0}];
      if (solids.empty() || solids.back() != b) solids.push_back(b);
    }
  }
}

std::vector<std::uint32_t> OwnBlockers::of(const ConvexPolygon& facet) const {
  std::vector<std::uint32_t> common;
  bool first = true;
  for (const Point3& p : facet.points()) {
    const auto found = solids_at_.find({p.x + 0.0, p.y + 0.0, p.z + 0.0});
    if (found == solids_at_.end()) return {};
    if (first) common = found->second;
    first = false;
    std::erase_if(common,
                  [&](std::uint32_t b) { return !std::binary_search(found->second.begin(), found->second.end(), b); });
  }
  return common;
}

}  // namespace gnomon
