#pragma once

/// What is left of a convex polygon without others, exactly. Private to this folder.

#include <array>
#include <span>
#include <vector>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

namespace gnomon {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;

/// Corners of a strictly convex polygon, counterclockwise.
using ConvexLoop = std::vector<ExactKernel::Point_2>;

/// A piece of a boundary; what it bounds lies to its left.
using BoundaryEdge = std::array<ExactKernel::Point_2, 2>;

/// The boundary of what is left of `whole`, regularised, without all of `taken`.
///
/// Requires:   each of `taken` lies in `whole` and has an area.
/// Returns:    edges that meet each other in common ends only.
/// Degenerate: polygons may coincide, share parts of edges and touch.
/// Exactness:  filtered exact signs; ends are crossings of two given edges' lines.
/// Cost:       O(n k) for n edges of k polygons; less where single ones hide whole edges of others.
std::vector<BoundaryEdge> convex_difference(const ConvexLoop& whole, std::span<const ConvexLoop> taken);

}  // namespace gnomon
