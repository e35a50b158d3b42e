#pragma once

#include <array>
#include <cstdint>

#include "gnomon/flatland_regions.h"
#include "gnomon/names.h"
#include "gnomon/shadow_volume.h"

namespace gnomon::laws {

/// What the cases of a law consist of: how many points lie where, and how many cases have how many regions. It shows
/// whether a law was tried where it says something.
struct Census {
  std::uint32_t cases = 0;                   ///< cases that were looked at
  std::array<std::uint32_t, 4> points{};     ///< cases by the region of their point: lit, penumbra, umbra, unlit
  std::array<std::uint32_t, 3> umbrae{};     ///< cases with 0, 1, 2 and more umbrae
  std::array<std::uint32_t, 4> penumbrae{};  ///< cases with 0, 1, 2, 3 and more penumbrae
  std::array<std::uint32_t, 3> pockets{};    ///< cases with 0, 1, 2 and more pockets of umbra outside a solid

  void add_point(Region region);
  void add_umbrae(std::size_t count);
  void add_penumbrae(std::size_t count);
  void add_pockets(std::size_t count);

  /// The regions of one pair.
  void add(const planar::ShadowRegions& regions);
  void add(const ShadowVolumes& volumes);

  Census& operator+=(const Census& other);
};

}  // namespace gnomon::laws
