#include "gnomon/flatland_pair.h"

#include <algorithm>
#include <cmath>

#include "geometry/planar/orientation.h"
#include "gnomon/errors.h"

namespace gnomon::planar {

Pair Pair::from_points(std::span<const Point2> light, std::span<const Point2> blocker) {
  const auto is_finite = [](const Point2& p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  if (!std::ranges::all_of(light, is_finite) || !std::ranges::all_of(blocker, is_finite)) {
    throw PreconditionError("a point of a planar light or blocker is not finite");
  }
  if (light.empty() || light.size() > 2 || (light.size() == 2 && light[0] == light[1])) {
    throw PreconditionError("a planar light is one point or two different points");
  }
  if (blocker.size() != 2 || blocker[0] == blocker[1]) {
    throw PreconditionError("a planar blocker is two different points");
  }
  Pair pair;
  std::ranges::copy(light, pair.light_.begin());
  std::ranges::copy(blocker, pair.blocker_.begin());
  pair.light_size_ = static_cast<std::uint32_t>(light.size());
  return pair;
}

Position pair_position(const Pair& pair) {
  const auto& [b0, b1] = pair.blocker();
  const Point2& l0 = pair.light().front();
  const Point2& l1 = pair.light().back();
  const int side0 = orientation(b0, b1, l0);
  const int side1 = pair.has_point_light() ? side0 : orientation(b0, b1, l1);
  if (side0 == 0 && side1 == 0) return Position::coplanar;
  if (side0 * side1 < 0) {
    const bool blocker_crosses = orientation(l0, l1, b0) * orientation(l0, l1, b1) < 0;
    return blocker_crosses ? Position::both_cross : Position::light_crosses_blocker_plane;
  }
  return side0 * side1 == 0 ? Position::touching : Position::standard;
}

}  // namespace gnomon::planar
