#pragma once

#include <vector>

#include "geometry/scene/flat_ring.h"

namespace gnomon {

/// The constrained Delaunay triangulation of what lies inside the first ring and outside of the others.
///
/// Requires:    simple rings of points of the plane, apart from each other, the others inside the first.
/// Orientation: counterclockwise.
std::vector<Ring> ring_triangles(const FlatRing& points, const std::vector<Ring>& rings);

/// The triangles joined along shared edges, in the order of their indices, wherever the union is convex.
std::vector<Ring> joined_triangles(const FlatRing& points, std::vector<Ring> triangles);

}  // namespace gnomon
