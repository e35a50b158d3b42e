#pragma once

#include "geometry/spatial/exact_surface.h"

namespace gnomon {

/// The boundary of a bounded convex polyhedron.
ExactSurface surface(const ConvexPolyhedron& polyhedron);

/// The boundary of a bounded convex polyhedron minus another one that is part of it: of the occlusion minus the umbra,
/// of the umbra minus a solid.
///
/// Definition: facets of the outer one, and those of the inner one turned inward; where both have a facet in one plane
///             the difference of the two polygons. No vertex lies inside an edge. Where the surface touches itself
///             along an edge or at a vertex, it has a copy of the vertices for each of its sheets.
/// Requires:   `inner` is part of `outer`.
/// Cost:       O(vertices of the inner * faces of the outer one).
ExactSurface difference_surface(ExactSpace& space, const ConvexPolyhedron& outer, const ConvexPolyhedron& inner);

}  // namespace gnomon
