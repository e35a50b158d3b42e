#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "gnomon/result.h"
#include "gnomon/shadow_volume.h"

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
