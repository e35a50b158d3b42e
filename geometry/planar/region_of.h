#pragma once

#include "geometry/planar/pair.h"
#include "geometry/region.h"

namespace gnomon::planar {

/// The region of a point, by the definition of the visible fraction: a point is blocked from a point of the light if
/// the open segment between them meets the blocker. Lights of the plane have no back, so no point is unlit.
///
/// Degenerate: what hides a part of length zero of a linear light does not count; it hides a point light. A point on
///             the blocker sees a light that is not on the blocker's line.
/// Exactness:  signs of orientation determinants of input points and the point itself, in every position.
/// After:      [P93] §4.2.2.1, properties 1 to 4.
Region region_of(const Pair& pair, const Point2& point);

}  // namespace gnomon::planar
