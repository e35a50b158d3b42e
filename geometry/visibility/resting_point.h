#pragma once

#include "geometry/visibility/light_visibility.h"

namespace gnomon {

/// A point with a normal as a receiver's point, with the blockers that it rests on: they lie under it and hide nothing
/// from it. So a point that was computed on a facet and rounded is not hidden by that facet, on which side of it
/// rounding may have put it.
///
/// Definition: a point is within rounding of a facet if it would meet the facet after each of its coordinates is moved
///             by at most 8 u of the larger of its own size and that of the facet's corners. It rests on the facet if
///             it is so but not within rounding of the facet's sides, and the planes of receiver and facet, of a solid
///             its outer side, make an angle of at most 60 degrees.
/// Exactness:  rational arithmetic where doubles do not decide. A point that lies exactly on a facet rests on it too.
ReceiverPoint resting_point(const PreparedObstacles& obstacles, const Point3& p, const Point3& normal);

/// True if the point is within rounding of a blocker's facet and not on its plane: rounding may have put it on the
/// wrong side.
bool is_within_rounding(const PreparedObstacles& obstacles, const Point3& p);

}  // namespace gnomon
