#pragma once

#include <span>
#include <vector>

#include "geometry/discontinuity/event_name.h"
#include "geometry/point.h"
#include "geometry/spatial/convex_blocker.h"
#include "geometry/spatial/convex_polygon.h"
#include "geometry/spatial/light.h"

namespace gnomon {

/// A discontinuity in space: the part of an event's plane on which vertex and edge are in line with visible points of
/// the light.
///
/// Definition: it begins at the element that is farther from the light and ends where the first blocker or receiver
///             stops it, or at the clip box.
struct DiscontinuitySurface {
  EventName name;
  std::vector<std::vector<Point3>> polygons;  ///< convex pieces, not overlapping; rounded to nearest
};

/// All edge-vertex surfaces of a scene of one light, cut by a box. Surfaces that are stopped where they begin, or lie
/// outside the box, are left out; so are pieces so thin that rounding leaves them fewer than three different corners.
///
/// Requires:  flat receivers and a flat area light; a box with an interior.
/// Exactness: which surfaces there are and where they end is exact; coordinates are rounded once.
/// Throws:    PreconditionError.
/// After:     [P93] §4.2.3.2.
std::vector<DiscontinuitySurface> discontinuity_surfaces(const Light& light, std::span<const ConvexBlocker> blockers,
                                                         std::span<const ConvexPolygon> receivers, const Box3& box);

}  // namespace gnomon
