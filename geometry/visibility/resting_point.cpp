#include <algorithm>

#include "geometry/numbers/orientation.h"
#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/prepared_obstacles.h"
#include "geometry/visibility/rounding_distance.h"

namespace gnomon {
namespace {

using Content = BlockerSet::Content;

/// Calls `look(corners, is_solid)` for each facet of the blocker, a flat one's corners among them, until it returns
/// true.
template <class Look>
bool any_facet(const Content& content, std::uint32_t blocker, Look look) {
  const Content::Shape& shape = content.shapes[blocker];
  if (shape.solid < 0) return look(content.corners(shape), false);
  const ConvexSolid& solid = content.solids[static_cast<std::size_t>(shape.solid)];
  std::vector<Point3> corners;
  return std::any_of(solid.facets().begin(), solid.facets().end(), [&](const ConvexSolid::Facet& facet) {
    corners.clear();
    for (const std::uint32_t i : facet.loop) corners.push_back(solid.points()[i]);
    return look(std::span<const Point3>(corners), true);
  });
}

}  // namespace

ReceiverPoint resting_point(const PreparedObstacles& obstacles, const Point3& p, const Point3& normal) {
  ReceiverPoint receiver{p, FacingNormal{normal}};
  const Content& content = obstacles.content().blockers.content();
  content.collect_near(p, receiver.under);
  std::erase_if(receiver.under, [&](std::uint32_t blocker) {
    return !any_facet(content, blocker, [&](std::span<const Point3> corners, bool is_solid) {
      return sight::nearness(corners, p) == sight::Nearness::inside && sight::faces_alike(corners, normal, is_solid);
    });
  });
  return receiver;
}

bool is_within_rounding(const PreparedObstacles& obstacles, const Point3& p) {
  const Content& content = obstacles.content().blockers.content();
  std::vector<std::uint32_t> near;
  content.collect_near(p, near);
  return std::any_of(near.begin(), near.end(), [&](std::uint32_t blocker) {
    return any_facet(content, blocker, [&](std::span<const Point3> corners, bool) {
      return sight::nearness(corners, p) != sight::Nearness::apart &&
             exact_orientation(corners[0], corners[1], corners[2], p) != 0;
    });
  });
}

}  // namespace gnomon
