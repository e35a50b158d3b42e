#pragma once

#include <cstdint>
#include <vector>

#include "geometry/spatial/body_pair.h"
#include "geometry/spatial/exact_space.h"
#include "geometry/spatial/pair.h"
#include "gnomon/shadow_volume.h"

namespace gnomon {

/// The half-spaces whose intersections are the occlusion and the umbra of a pair.
struct PairHalfSpaces {
  static constexpr std::uint32_t none = ~0u;

  bool occlusion_empty = false;      ///< no point loses a measurable part of the light
  bool umbra_empty = false;          ///< the umbra has no interior
  std::vector<HalfSpace> occlusion;  ///< not empty and no half-space: all of space
  std::vector<HalfSpace> umbra;
  std::vector<std::uint32_t> shared;  ///< for every one of `umbra`: the one of `occlusion` in the same plane, or none
};

/// The half-spaces of a pair in any position.
///
/// Definition: the occlusion is the slice w = 1 of the cone of all (b, 1) and (-l, -1); its facets lie in planes that
///             separate the light from the blocker. The umbra is the intersection of the shadows of the light's
///             corners outside the blocker, bounded by facets that one of these sees and by supporting planes; where a
///             part of the light with extent lies in a facet of a solid, that facet's plane bounds it too. Both are cut
///             by a one-sided flat light's plane where the blocker does not lie strictly in front of it.
/// Requires:   no pair_refusal(light, blocker).
/// Exactness:  signs of orientation determinants of input points; where the light reaches into a solid, exact
///             arithmetic on points constructed on the light.
/// After:      [P93] §5.2.3; theory S6, S9, S11.
PairHalfSpaces pair_half_spaces(const BodyPair& pair, const Light& light);

/// The half-space behind a facet of the blocker.
HalfSpace facet_half_space(const BodyPair& pair, std::uint32_t facet);

void append(std::vector<HalfSpace>& to, const std::vector<HalfSpace>& from);

/// The contacts of a pair in standard position.
struct StandardContacts {
  explicit StandardContacts(const StandardPair& pair);

  std::vector<TouchedCorners> separating;     ///< for each blocker side
  std::vector<TouchedCorners> supporting;     ///< for each blocker side
  std::vector<LightSideContact> light_sides;  ///< from separating_light_contacts
};

/// The half-spaces of a pair in standard position, from one walk around both rings.
///
/// Returns: occlusion: the blocker's face, one half-space for each blocker side, those of the light sides in the order
///          of the walk; umbra: the blocker's face, one half-space for each blocker side.
/// Cost:    O(n + m).
PairHalfSpaces standard_half_spaces(const StandardPair& pair, const StandardContacts& contacts);

/// The blocker's corners, in the order of its ring.
std::vector<VertexId> standard_corners(ExactSpace& space, const StandardPair& pair);

}  // namespace gnomon
