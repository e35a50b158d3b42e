#pragma once

#include <array>

#include <boost/container/small_vector.hpp>

#include "geometry/spatial/convex_polyhedron.h"

namespace gnomon {

/// Most are those of a face of few corners.
using Triangles = boost::container::small_vector<std::array<VertexId, 3>, 4>;

/// Triangles of a convex polygon whose boundary may have straight vertices.
///
/// Requires: `loop` runs counterclockwise in `plane`, seen from outside.
/// Returns:  triangles of positive area that use every vertex; every edge of the loop is an edge of one triangle.
Triangles convex_triangles(const ExactSpace& space, PlaneId plane, Loop loop);

/// Triangles of the outer polygon minus the inner one.
///
/// Requires: both loops convex and counterclockwise; the inner one strictly convex and part of the outer one; every
///           vertex of the inner one that lies on the outer boundary is a vertex of the outer loop. The inner one may
///           be a point or the two ends of an edge, which then is an edge of triangles on both sides.
/// Returns:  as convex_triangles; nothing where the boundaries coincide.
/// Cost:     O(size of both loops).
Triangles difference_triangles(const ExactSpace& space, PlaneId plane, const Loop& outer, const Loop& inner);

}  // namespace gnomon
