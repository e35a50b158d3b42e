#pragma once

#include <vector>

#include "geometry/spatial/convex_polyhedron.h"
#include "geometry/spatial/difference_triangulation.h"

namespace gnomon {

/// A closed surface of triangles over the vertices of an ExactSpace.
struct ExactSurface {
  struct Facet {
    PlaneId plane;        ///< through all its vertices; for a facet turned inward its inside is the volume's outside
    Triangles triangles;  ///< counterclockwise seen from outside the volume
  };
  std::vector<Facet> facets;
};

}  // namespace gnomon
