#include <algorithm>
#include <utility>

#include "geometry/bodies/plate.h"
#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/orientation.h"
#include "geometry/visibility/blocker_content.h"
#include "geometry/visibility/prepared_obstacles.h"
#include "geometry/visibility/rounding_distance.h"

namespace gnomon {
namespace {

using Content = BlockerSet::Content;

/// The corners of the polygon that a thin solid stands for whose vertices were rounded off their plane; none of others.
std::vector<Point3> plate_corners(const ConvexSolid& solid) {
  std::vector<Point3> ring = plate_ring(solid);
  if (ring.empty()) return {};
  const ConvexPolygon polygon = ConvexPolygon::from_points(std::move(ring));
  std::vector<Point3> corners;
  for (const std::uint32_t i : polygon.corners()) corners.push_back(polygon.points()[i]);
  return corners;
}

/// Calls `look(corners, is_solid)` for each facet of the blocker, a flat one's corners among them, until it returns
/// true.
template <class Look>
bool any_facet(const Content& content, std::uint32_t blocker, Look look) {
  const Content::Shape& shape = content.shapes[blocker];
  if (shape.solid < 0) return look(content.corners(shape), false);
  const ConvexSolid& solid = content.solids[static_cast<std::size_t>(shape.solid)];
  std::vector<Point3> corners = plate_corners(solid);
  if (!corners.empty()) return look(std::span<const Point3>(corners), false);
  return std::any_of(solid.facets().begin(), solid.facets().end(), [&](const ConvexSolid::Facet& facet) {
    corners.clear();
    for (const std::uint32_t i : facet.loop) corners.push_back(solid.points()[i]);
    return look(std::span<const Point3>(corners), true);
  });
}

/// A facet that a point is within rounding of.
struct NearFacet {
  std::uint32_t blocker = 0;
  std::vector<Point3> corners;
  bool is_inside = false;  ///< not within rounding of a side
};

/// Those whose planes, of solids the outer sides, make an angle of at most 60 degrees with the receiver's.
std::vector<NearFacet> near_facets(const Content& content, std::span<const std::uint32_t> blockers, const Point3& p,
                                   const Point3& normal) {
  std::vector<NearFacet> found;
  for (const std::uint32_t blocker : blockers) {
    any_facet(content, blocker, [&](std::span<const Point3> corners, bool is_solid) {
      const viewpoint::Nearness nearness = viewpoint::nearness(corners, p);
      if (nearness != viewpoint::Nearness::apart && viewpoint::faces_alike(corners, normal, is_solid)) {
        found.push_back({blocker, {corners.begin(), corners.end()}, nearness == viewpoint::Nearness::inside});
      }
      return false;
    });
  }
  return found;
}

/// Whether a facet goes on beyond a side of another, in its plane but for rounding.
bool continues(const NearFacet& other, const NearFacet& facet, std::size_t side) {
  if (!viewpoint::reaches_beyond(facet.corners, side, other.corners)) return false;
  std::vector<Point3> both = facet.corners;
  both.insert(both.end(), other.corners.begin(), other.corners.end());
  const auto plane = polygon_plane(both);
  return plane && plane->flatness <= Flatness::rounded;
}

bool rests_on(const NearFacet& facet, std::span<const NearFacet> all, const Point3& p) {
  if (facet.is_inside) return true;
  for (std::size_t side = 0; side < facet.corners.size(); ++side) {
    if (!viewpoint::is_near_side(facet.corners, side, p)) continue;
    if (std::ranges::none_of(all, [&](const NearFacet& other) { return continues(other, facet, side); })) return false;
  }
  return true;
}

}  // namespace

ReceiverPoint resting_point(const PreparedObstacles& obstacles, const Point3& p, const Point3& normal) {
  ReceiverPoint receiver{p, FacingNormal{normal}};
  const Content& content = obstacles.content().blockers.content();
  content.collect_near(p, receiver.under);
  const std::vector<NearFacet> facets = near_facets(content, receiver.under, p, normal);
  std::erase_if(receiver.under, [&](std::uint32_t blocker) {
    return std::ranges::none_of(
        facets, [&](const NearFacet& facet) { return facet.blocker == blocker && rests_on(facet, facets, p); });
  });
  return receiver;
}

bool is_within_rounding(const PreparedObstacles& obstacles, const Point3& p) {
  const Content& content = obstacles.content().blockers.content();
  std::vector<std::uint32_t> near;
  content.collect_near(p, near);
  return std::any_of(near.begin(), near.end(), [&](std::uint32_t blocker) {
    return any_facet(content, blocker, [&](std::span<const Point3> corners, bool) {
      return viewpoint::nearness(corners, p) != viewpoint::Nearness::apart &&
             exact_orientation(corners[0], corners[1], corners[2], p) != 0;
    });
  });
}

}  // namespace gnomon
