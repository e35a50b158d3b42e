#include "geometry/planar/shadow_side.h"

#include <algorithm>

#include "geometry/planar/orientation.h"

namespace gnomon::planar {
namespace {

BoundaryRay light_ray(const Pair& pair, Contact contact, BlockerVertex end, LightVertex light) {
  const SideKind kind = contact == Contact::separating ? SideKind::separating : SideKind::supporting;
  const SideName name{kind, end, light};
  return {name, pair.blocker_end(end), pair.light_end(light)};
}

/// The side opposite to a light on the side `light_side` of the directed line of the blocker, with its ends alone.
ShadowSide side_behind(int light_side) {
  ShadowSide side;
  side.first = BlockerVertex{light_side > 0 ? 1U : 0U};
  side.last = other_end(side.first);
  return side;
}

/// P1 to P7: the light strictly on the side `light_side`.
ShadowSide standard_side(const Pair& pair, int light_side) {
  ShadowSide side = side_behind(light_side);
  const auto lines = extremal_lines(pair);
  const auto ray = [&](Contact contact, BlockerVertex end) {
    const ExtremalLine& line = lines[number(end) + (contact == Contact::supporting ? 2U : 0U)];
    return light_ray(pair, contact, end, line.light_end);
  };
  side.outer = {ray(Contact::separating, side.first), ray(Contact::separating, side.last)};
  side.inner = {ray(Contact::supporting, side.first), ray(Contact::supporting, side.last)};
  const auto& [right, left] = *side.inner;
  side.umbra_bounded = turn(right.anchor, right.start, left.anchor, left.start) > 0;
  return side;
}

/// The end of the blocker at or beyond which the light's line meets the blocker's line; nothing if it meets the inside
/// of the blocker. `far` is strictly on the side `light_side`, `near` is on the line or beyond it.
std::optional<BlockerVertex> passed_end(const Pair& pair, int light_side, const Point2& near, const Point2& far) {
  if (light_side * orientation(near, far, pair.blocker()[1]) >= 0) return BlockerVertex{1};
  if (light_side * orientation(near, far, pair.blocker()[0]) <= 0) return BlockerVertex{0};
  return std::nullopt;
}

/// P8: the shadow of the part of the light between the blocker's line and the light end `far`, which lies on the side
/// `light_side`; the other light end lies on the line or beyond it.
ShadowSide crossed_side(const Pair& pair, LightVertex far, int light_side, bool touching) {
  ShadowSide side = side_behind(light_side);
  const Point2& near = pair.light()[1 - number(far)];
  const auto passed = passed_end(pair, light_side, near, pair.light_end(far));
  const std::array ends{side.first, side.last};
  bool at_blocker = !passed;
  for (const std::size_t k : {0U, 1U}) {
    const bool is_passed = passed == ends[k];
    side.outer[k] = is_passed ? light_ray(pair, Contact::separating, ends[k], far) : blocker_ray(pair, ends[k]);
    const bool on_light_line = is_passed && orientation(near, pair.light_end(far), pair.blocker_end(ends[k])) == 0;
    side.outer_hides[k] = on_light_line && !touching;
    at_blocker = at_blocker || on_light_line;
  }
  if (touching && at_blocker) {
    side.inner = {light_ray(pair, Contact::supporting, side.first, far),
                  light_ray(pair, Contact::supporting, side.last, far)};
  }
  return side;
}

}  // namespace

BoundaryRay blocker_ray(const Pair& pair, BlockerVertex end) {
  const SideName name{SideKind::blocker_line, end};
  return {name, pair.blocker_end(end), pair.blocker_end(other_end(end))};
}

std::vector<ShadowSide> shadow_sides(const Pair& pair) {
  const Position position = pair_position(pair);
  if (position == Position::coplanar) return {};
  const auto side_of = [&](const Point2& p) { return orientation(pair.blocker()[0], pair.blocker()[1], p); };
  if (position == Position::standard) return {standard_side(pair, side_of(pair.light().front()))};
  std::vector<ShadowSide> sides;
  for (const std::uint32_t j : {0U, 1U}) {
    const int light_side = side_of(pair.light()[j]);
    if (light_side != 0) {
      sides.push_back(crossed_side(pair, LightVertex{j}, light_side, position == Position::touching));
    }
  }
  return sides;
}

double along(const Pair& pair, const Point2& point) {
  return pair.blocker()[0].x != pair.blocker()[1].x ? point.x : point.y;
}

CommonLine common_line(const Pair& pair) {
  const auto [blocker_min, blocker_max] = std::minmax({along(pair, pair.blocker()[0]), along(pair, pair.blocker()[1])});
  const auto [light_min, light_max] =
      std::minmax({along(pair, pair.light().front()), along(pair, pair.light().back())});
  return {blocker_min, blocker_max, light_min, light_max};
}

}  // namespace gnomon::planar
