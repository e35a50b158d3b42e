#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gnomon/flatland_regions.h"

namespace gnomon::planar {

/// A ray that starts at an end of the blocker and runs away from `anchor`: from a light end, or, along the blocker's
/// own line, from the blocker's other end. It bounds a region.
struct BoundaryRay {
  SideName name;
  Point2 start;
  Point2 anchor;

  bool on_blocker_line() const { return name.kind == SideKind::blocker_line; }
};

/// The ray on the blocker's line beyond one of its ends.
BoundaryRay blocker_ray(const Pair& pair, BlockerVertex end);

/// The shadow on one side of the blocker's line, thrown by the part of the light on the other side.
///
/// Orientation: the shadow lies left of the blocker as it runs from end `first` to end `last`.
struct ShadowSide {
  BlockerVertex first{};
  BlockerVertex last{};
  /// What bounds the occlusion at `first` and `last`.
  std::array<BoundaryRay, 2> outer;
  /// What bounds the umbra at `first` and `last`; nothing if there is no umbra.
  std::optional<std::array<BoundaryRay, 2>> inner;
  /// True if the rays of `inner` meet.
  bool umbra_bounded = false;
  /// True if points of the ray `outer` at `first` or `last` lose a part of the light although they lie in no umbra:
  /// the light's line is that ray's, and a part of the light with some length lies behind the blocker's end.
  std::array<bool, 2> outer_hides{false, false};
};

/// One for every side of the blocker's line with a shadow: none if the light lies on this line, two if it crosses it.
///
/// Exactness: signs of orientation determinants of input points.
std::vector<ShadowSide> shadow_sides(const Pair& pair);

/// Where light and blocker lie on one line: their extents along it. A point light has light_min = light_max.
struct CommonLine {
  double blocker_min;
  double blocker_max;
  double light_min;
  double light_max;
};

/// The coordinate by which points of the blocker's line are ordered along it: x, or y if the line is vertical.
double along(const Pair& pair, const Point2& point);

/// Requires: pair_position(pair) == Position::coplanar.
CommonLine common_line(const Pair& pair);

}  // namespace gnomon::planar
