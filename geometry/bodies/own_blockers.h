#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "geometry/numbers/place_key.h"
#include "gnomon/blocker.h"

namespace gnomon {

/// Which solids have the corners of a facet among their vertices and stand behind it but for rounding: those that the
/// facet is one of, and thin ones that stand for it. Where vertices are not exactly coplanar the facet may lie behind
/// their hull, and they must not hide the light from it.
class OwnBlockers {
 public:
  /// The blockers outlive it.
  explicit OwnBlockers(std::span<const ConvexBlocker> blockers);

  /// Their indices, ascending. The facet's front is the side that its vertices go round counterclockwise.
  std::vector<std::uint32_t> of(const ConvexPolygon& facet) const;

 private:
  std::span<const ConvexBlocker> blockers_;
  std::map<PlaceKey, std::vector<std::uint32_t>> solids_at_;  ///< ascending
};

}  // namespace gnomon
