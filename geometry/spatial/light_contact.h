#pragma once

#include <cstdint>
#include <vector>

#include "geometry/spatial/body_pair.h"

namespace gnomon {

/// Where the light meets the blocker.
///
/// Exactness: exact throughout.
struct LightContact {
  bool meets = false;                          ///< they have a point in common
  bool meets_interior = false;                 ///< a point of the light lies inside a solid
  std::vector<std::uint32_t> corners_outside;  ///< corners of the light that are no points of the blocker
  std::vector<std::uint32_t> shared_facets;    ///< facets of a solid that hold a part of the light with extent
};

/// Requires: light and blocker not in one plane; the light not at infinity.
LightContact light_contact(const BodyPair& pair);

}  // namespace gnomon
