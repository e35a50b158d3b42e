#include "geometry/visibility/linear_search/plane_search.h"

namespace gnomon::viewpoint {
namespace {

bool may_cut(const Plane& plane, const Point3& apex, std::span<const Point3> points) {
  bool before = false;
  bool behind = false;
  for (const Point3& p : points) {
    const std::int8_t side = certain_side(plane, Ray(apex, p));
    before = before || side != -1;
    behind = behind || side != 1;
  }
  return before && behind;
}

}  // namespace

void PlaneSearch::find_candidates(const LightTriangle& triangle, std::vector<std::uint32_t>& found,
                                  SearchCounts& counts) const {
  found.clear();
  const BlockerSet::Content& blockers = blockers_.content();
  const Plane& plane = triangle.pyramid.sides[0];
  for (std::uint32_t b = 0; b < blockers.shapes.size(); ++b) {
    if (may_cut(plane, triangle.corners[0], blockers.points_of(blockers.shapes[b]))) found.push_back(b);
  }
  counts.tested += blockers.shapes.size();
}

}  // namespace gnomon::viewpoint
