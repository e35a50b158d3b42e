#pragma once

#include <cstddef>

#include "tests/benchmarks/polygon_pairs.h"

namespace gnomon::benchmarks {

/// Facets of the hull of all vertex shadows, cut off: the blocker's vertices b, and b + t (b - l) for every light
/// vertex l, with t such that the far points lie in one plane z = const below. CGAL's convex_hull_3, EPICK.
///
/// Requires: every light vertex lies above z = 3, every blocker vertex between z = 1 and z = 3.
std::size_t facets_of_vertex_shadow_hull(const PolygonPair& pair);

/// Facets of the occlusion volume above z = -4, from the half-spaces of the given extremal planes.
/// CGAL's halfspace_intersection_3, EPICK.
std::size_t facets_of_halfspace_intersection(const PolygonPair& pair);

}  // namespace gnomon::benchmarks
