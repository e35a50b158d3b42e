#pragma once

#include <span>

#include "geometry/numbers/exact_vector.h"
#include "gnomon/visibility.h"

namespace gnomon {

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

/// The plane before which a receiver receives; its normal points to the front.
ExactPlane exact_front(const ReceiverPoint& receiver);

}  // namespace gnomon
