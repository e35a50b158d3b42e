#pragma once

#include <string_view>

namespace gnomon {

/// What a point receives of a light. The numbers are those of the `region` arrays in output files.
enum class Region {
  lit = 0,       ///< all of the light is visible: f = 1
  penumbra = 1,  ///< a part of it: 0 < f < 1
  umbra = 2,     ///< none of it: f = 0
  unlit = 3,     ///< the light shows its back or its edge; takes precedence over umbra
};

/// The region's name as scripts read it.
constexpr std::string_view name(Region region) {
  constexpr std::string_view names[] = {"lit", "penumbra", "umbra", "unlit"};
  return names[static_cast<int>(region)];
}

}  // namespace gnomon
