#pragma once

#include <span>
#include <vector>

#include "geometry/scene/polygon_rings.h"
#include "gnomon/point.h"

namespace gnomon {

/// Facets joined to convex polygons where that changes nothing of the surface.
///
/// Facets are neighbours if they are convex, exactly coplanar, have one front, and run along a whole edge in opposite
/// directions. All that hang together become one polygon if their common boundary is one; else pairs are joined for as
/// long as the pair is convex: no two neighbours that are left make a convex one.
///
/// Requires:   facets as checked_facets has them.
/// Returns:    rings, in the order of the first facet of each; they run as the facets do. Vertices at which a joined
///             boundary does not turn are left out; a facet that is not joined stays as it was.
/// Degenerate: facets are alike where their corners have equal coordinates, whatever their numbers. A facet that runs
///             along an edge as one before it does, in its plane with its front, is joined to none.
/// Exactness:  exact signs alone. The facets cover what the joined polygon covers, once: how often a point is covered
///             is how often boundaries wind around it, and edges run along both ways do not count.
std::vector<Ring> joined_facets(std::span<const Point3> points, std::span<const Ring> facets);

}  // namespace gnomon
