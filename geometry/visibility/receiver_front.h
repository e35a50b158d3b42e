#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "geometry/point.h"
#include "geometry/spatial/convex_polygon.h"

namespace gnomon {

/// The front of a receiver that is a point with a normal: what lies before the plane through the point at right angles
/// to the normal. The normal is not zero; its length does not matter.
struct FacingNormal {
  Point3 normal;
};

/// The front of a receiver that is a facet: what lies before the plane of three of its corners, which run
/// counterclockwise seen from the front. Points of the facet may be off the plane by what was rounded.
struct FacetFront {
  std::array<Point3, 3> corners;
};

/// The front of a convex polygon: the plane through its first three corners.
FacetFront facet_front(const ConvexPolygon& facet);

using ReceiverFront = std::variant<FacingNormal, FacetFront>;

/// A point of a receiver, and the side from which it receives.
struct ReceiverPoint {
  Point3 point;
  ReceiverFront front;
  /// Blockers, by their indices and ascending, that lie under the point and hide nothing from it.
  std::vector<std::uint32_t> under = {};
};

/// +1 before the receiver's plane, 0 in it, -1 behind it.
/// Exactness: exact for finite coordinates.
int side_of_front(const ReceiverPoint& receiver, const Point3& q);

/// The side of a point infinitely far away in a direction.
int side_of_front_towards(const ReceiverFront& front, const Point3& direction);

/// Which side of the plane through three points, that run counterclockwise seen from its positive one, a step along the
/// front's normal leads to.
int side_of_step(const ReceiverFront& front, const Point3& a, const Point3& b, const Point3& c);

/// True if one of the points lies before the receiver's plane.
bool reaches_before(const ReceiverPoint& receiver, std::span<const Point3> points);

}  // namespace gnomon
