#include "geometry/visibility/receiver_candidates.h"

#include <algorithm>

#include "geometry/numbers/orientation.h"

namespace gnomon::sight {
namespace {

/// Whether the box around the points holds p.
bool is_in_box(const Point3& p, std::span<const Point3> points) {
  const auto between = [&](double Point3::*axis) {
    bool below = false;
    bool above = false;
    for (const Point3& q : points) {
      below = below || q.*axis <= p.*axis;
      above = above || q.*axis >= p.*axis;
    }
    return below && above;
  };
  return between(&Point3::x) && between(&Point3::y) && between(&Point3::z);
}

bool may_hold(std::span<const Point3> corners, const Point3& p) {
  return is_in_box(p, corners) && exact_orientation(corners[0], corners[1], corners[2], p) == 0;
}

bool may_hold(const ConvexSolid& solid, const Point3& p) {
  const std::span<const Point3> points = solid.points();
  if (!is_in_box(p, points)) return false;
  return std::all_of(solid.facets().begin(), solid.facets().end(), [&](const ConvexSolid::Facet& facet) {
    return exact_orientation(points[facet.loop[0]], points[facet.loop[1]], points[facet.loop[2]], p) <= 0;
  });
}

}  // namespace

bool keep_before(const ReceiverPoint& receiver, const BlockerSet::Content& blockers,
                 std::vector<std::uint32_t>& found) {
  bool apart = true;
  std::erase_if(found, [&](std::uint32_t b) {
    if (std::binary_search(receiver.under.begin(), receiver.under.end(), b)) return true;
    const BlockerSet::Content::Shape& shape = blockers.shapes[b];
    const ConvexSolid* solid = shape.solid >= 0 ? &blockers.solids[static_cast<std::size_t>(shape.solid)] : nullptr;
    if (!reaches_before(receiver, solid ? solid->points() : blockers.corners(shape))) return true;
    apart = apart && !(solid ? may_hold(*solid, receiver.point) : may_hold(blockers.corners(shape), receiver.point));
    return false;
  });
  return apart;
}

}  // namespace gnomon::sight
