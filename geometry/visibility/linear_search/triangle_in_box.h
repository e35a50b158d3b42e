#pragma once

/// Private to geometry/visibility.

#include <array>
#include <span>

#include "gnomon/point.h"

namespace gnomon::viewpoint {

/// False only if the triangle has no point in the box.
///
/// Definition: nothing holds two convex sets together that some direction holds apart. Tried are the axes, the
///             triangle's normal, and the directions across an axis and a side.
/// Bound:      any direction will do, so that its own rounding does not matter; products and sums err by 8 u of the
///             greatest.
bool may_meet(const std::array<Point3, 3>& triangle, const Box3& box);

/// The same for a convex polygon, as triangles from its first corner.
bool may_meet(std::span<const Point3> polygon, const Box3& box);

}  // namespace gnomon::viewpoint
