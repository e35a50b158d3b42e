#include "geometry/visibility/receiver_candidates.h"

#include <algorithm>

#include "geometry/numbers/orientation.h"
#include "geometry/visibility/common_part.h"

namespace gnomon::viewpoint {
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

/// Whether the blocker holds p. Doubles say no of nearly all.
bool has_point(const BlockerSet::Content& blockers, std::uint32_t blocker, const Point3& p) {
  const BlockerSet::Content::Shape& shape = blockers.shapes[blocker];
  const std::span<const Point3> points = blockers.points_of(shape);
  if (!is_in_box(p, points)) return false;
  if (shape.solid < 0 && exact_orientation(points[0], points[1], points[2], p) != 0) return false;
  return have_common_point(blockers, blocker, {&p, 1});
}

}  // namespace

bool keep_before(const ReceiverPoint& receiver, const BlockerSet::Content& blockers,
                 std::vector<std::uint32_t>& found) {
  bool apart = true;
  std::erase_if(found, [&](std::uint32_t b) {
    if (std::binary_search(receiver.under.begin(), receiver.under.end(), b)) return true;
    if (!reaches_before(receiver, blockers.points_of(blockers.shapes[b]))) return true;
    apart = apart && !has_point(blockers, b, receiver.point);
    return false;
  });
  return apart;
}

}  // namespace gnomon::viewpoint
