#include "gnomon/flatland_pair.h"

#include <algorithm>

#include "geometry/planar/orientation.h"
#include "geometry/planar/shadow_side.h"

namespace gnomon::planar {
namespace {

/// P10, on the line that holds light and blocker.
Region region_on_common_line(const Pair& pair, const Point2& point) {
  const CommonLine line = common_line(pair);
  const double at = along(pair, point);
  if (at <= line.blocker_min) {  // hidden: the light beyond blocker_min
    if (line.light_max <= line.blocker_min) return Region::lit;
    return line.light_min >= line.blocker_min ? Region::umbra : Region::penumbra;
  }
  if (at >= line.blocker_max) {  // hidden: the light before blocker_max
    if (line.light_min >= line.blocker_max) return Region::lit;
    return line.light_max <= line.blocker_max ? Region::umbra : Region::penumbra;
  }
  return pair.has_point_light() && point == pair.light().front() ? Region::lit : Region::umbra;
}

/// On which side of the rays at the blocker's first and last end a point behind the blocker lies: +1 on the side of the
/// other ray, 0 on the ray's line.
std::array<int, 2> inner_sides(const std::array<BoundaryRay, 2>& rays, const Point2& point) {
  return {orientation(rays[0].start, rays[0].anchor, point), orientation(rays[1].anchor, rays[1].start, point)};
}

/// Requires: the point strictly on the shadow's side of the blocker's line.
Region region_behind(const ShadowSide& shadow, const Point2& point) {
  if (shadow.inner) {
    const auto side = inner_sides(*shadow.inner, point);
    if (side[0] >= 0 && side[1] >= 0) return Region::umbra;
  }
  const auto side = inner_sides(shadow.outer, point);
  const auto hidden = [&](std::size_t k) { return side[k] > 0 || (side[k] == 0 && shadow.outer_hides[k]); };
  return hidden(0) && hidden(1) ? Region::penumbra : Region::lit;
}

}  // namespace

Region region_of(const Pair& pair, const Point2& point) {
  const int point_side = orientation(pair.blocker()[0], pair.blocker()[1], point);
  const auto shadows = shadow_sides(pair);
  if (point_side == 0) return shadows.empty() ? region_on_common_line(pair, point) : Region::lit;
  const BlockerVertex first{point_side > 0 ? 0U : 1U};  // a shadow lies left of the blocker as it runs from `first`
  const auto shadow = std::ranges::find(shadows, first, &ShadowSide::first);
  return shadow == shadows.end() ? Region::lit : region_behind(*shadow, point);
}

}  // namespace gnomon::planar
