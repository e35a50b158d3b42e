#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/scene/polygon_rings.h"
#include "gnomon/scene.h"

namespace gnomon {

/// Cuts a polygon along diagonals into convex ones.
///
/// Requires:    the outer ring of a polygon and its holes, as scene files hold them: simple, apart from each other.
/// Returns:     indices of the vertices of each piece. Collinear vertices are kept.
/// Definition:  a bent polygon (see Flatness) is cut into triangles: the fan from its first vertex where that is convex
///              seen along the dominant axis, else the constrained Delaunay triangulation seen there. What has holes
///              is that triangulation too, with triangles joined where they make convex polygons.
/// Orientation: pieces run the same way round as the outer ring. Seen along its dominant axis they are convex, do not
///              overlap and fill it.
/// Exactness:   signs of determinants of input points; no vertex is constructed.
std::vector<Ring> convex_partition(std::span<const Point3> points, std::vector<Ring> rings);

/// The vertices of the pieces alone: of a polygon, and of a facet of a mesh, which is its own piece where it is convex.
std::vector<std::vector<std::uint32_t>> convex_pieces(const ConcavePolygon& polygon);
std::vector<std::vector<std::uint32_t>> convex_pieces(std::span<const Point3> points,
                                                      const std::vector<std::uint32_t>& facet);

}  // namespace gnomon
