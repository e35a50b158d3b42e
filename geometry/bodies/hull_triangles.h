#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gnomon/point.h"

namespace gnomon {

/// Three indices of points; counterclockwise seen from outside.
using HullTriangle = std::array<std::uint32_t, 3>;

/// The boundary of the convex hull of points, as a closed surface of triangles.
///
/// Requires:   finite points, none repeated.
/// Returns:    triangles with an area; each edge is in two of them, in opposite directions. Nothing if all points lie
///             in one plane.
/// Degenerate: neighbours may be coplanar, and corners of triangles may lie inside facets or edges of the hull.
/// Exactness:  signs of orientation determinants of input points.
/// Cost:       O(n log n) predicates on average over the order in which the points are taken; that order is fixed and
///             has nothing to do with the order given.
std::vector<HullTriangle> hull_triangles(std::span<const Point3> points);

}  // namespace gnomon
