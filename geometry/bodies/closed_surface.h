#pragma once

#include "geometry/numbers/exact_vector.h"
#include "gnomon/blocker.h"

namespace gnomon {

/// True if the surface winds around the point: the point lies strictly inside what the surface encloses, whichever
/// way its triangles run. A cavity is outside, what two overlapping shells share is inside.
///
/// Degenerate: false on the surface itself. Triangles without area are harmless.
/// Exactness:  signs of orientation determinants of input points.
/// Cost:       O(number of triangles).
bool is_strictly_inside(const Point3& point, const ClosedSurface& surface);
bool encloses(const ClosedSurface& surface, const ExactVector& point);

}  // namespace gnomon
