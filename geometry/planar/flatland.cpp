#include "gnomon/flatland.h"

#include <algorithm>
#include <cmath>

#include "gnomon/errors.h"

namespace gnomon::planar {
namespace {

bool is_finite(const Point2& p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

bool is_segment(const BlockerSegment& blocker) {
  return is_finite(blocker[0]) && is_finite(blocker[1]) && blocker[0] != blocker[1];
}

}  // namespace

Flatland Flatland::from_points(std::span<const Point2> light, std::span<const BlockerSegment> blockers) {
  if (light.empty() || light.size() > 2 || (light.size() == 2 && light[0] == light[1])) {
    throw PreconditionError("a planar light is one point or two different points");
  }
  if (!std::ranges::all_of(light, is_finite)) throw PreconditionError("a point of a planar light is not finite");
  if (!std::ranges::all_of(blockers, is_segment)) {
    throw PreconditionError("a planar blocker is two different finite points");
  }
  Flatland flatland;
  std::ranges::copy(light, flatland.light_.begin());
  flatland.light_size_ = static_cast<std::uint32_t>(light.size());
  flatland.blockers_.assign(blockers.begin(), blockers.end());
  return flatland;
}

std::vector<BlockerSegment> segments_of_polyline(std::span<const Point2> polyline) {
  if (polyline.size() < 2) throw PreconditionError("a polyline has at least two points");
  std::vector<BlockerSegment> segments;
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) segments.push_back({polyline[i], polyline[i + 1]});
  return segments;
}

}  // namespace gnomon::planar
