#pragma once

#include <array>
#include <vector>

#include "geometry/spatial/shadow_polyhedra.h"

namespace gnomon {

/// A closed surface of triangles over the vertices of an ExactSpace.
struct ExactSurface {
  struct Facet {
    PlaneId plane;  ///< through all its vertices; for a facet turned inward its inside is the outside of the volume
    std::vector<std::array<VertexId, 3>> triangles;  ///< counterclockwise seen from outside the volume
  };
  std::vector<Facet> facets;
};

/// The boundary of a bounded convex polyhedron.
ExactSurface surface(const ConvexPolyhedron& polyhedron);

/// The boundary of occlusion minus umbra, both cut by the box with planes `box`.
///
/// Definition: facets of the occlusion, and those of the umbra turned inward; where both have a facet in one plane
///             (the blocker, the box, a plane that holds a linear light) the difference of the two polygons.
///             No vertex lies inside an edge. Where the surface touches itself along an edge or at a vertex, it
///             has a copy of the vertices for each of its sheets.
/// Requires:   the umbra is part of the occlusion, as for every pair; both bounded.
ExactSurface penumbra_surface(ExactSpace& space, const ConvexPolyhedron& occlusion, const ConvexPolyhedron& umbra,
                              const ShadowPolyhedra& polyhedra, const PairHalfSpaces& half_spaces,
                              const std::array<PlaneId, 6>& box);

}  // namespace gnomon
