#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.h"

namespace gnomon {

/// Cuts a simple polygon along diagonals into convex ones.
///
/// Requires:    the vertices of a simple polygon, coplanar up to rounding, as scene files hold them.
/// Returns:     indices of the vertices of each piece. Collinear vertices are kept.
/// Orientation: pieces run the same way round as the polygon. Seen along its dominant axis they are convex, do not
///              overlap and fill it.
/// Exactness:   signs of orientation determinants of input points.
std::vector<std::vector<std::uint32_t>> convex_partition(std::span<const Point3> polygon);

}  // namespace gnomon
