#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "geometry/spatial/shadow_volume.h"
#include "viz/shadow_result.h"

namespace gnomon {

/// What is told of the occlusion, the umbra or the penumbra of a pair, in space and in the plane.
struct ShadowExtent {
  std::string_view name;
  VolumeFacts facts;
  double size_in_box = 0;  ///< volume, or area in the plane
};

/// Occlusion, umbra and penumbra of a supported pair, by the pair's place in the result's list.
std::array<ShadowExtent, 3> shadow_extents(const ShadowResult& result, std::size_t pair);

}  // namespace gnomon
