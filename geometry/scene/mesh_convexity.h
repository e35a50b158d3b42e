#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gnomon/point.h"

namespace gnomon {

/// How far a closed mesh is from being convex: the largest height of a vertex over the plane of three corners of a
/// facet, on the side to which the facets' fronts or, if they run inward, their backs point. 0: the mesh is the surface
/// of the hull of its vertices. Nothing if that is more than 1e-9 of the mesh's diameter, or the mesh lies in one
/// plane.
///
/// Definition: three corners stand for every triangle of the fan from a facet's first corner. The diameter is that of
///             the box around the mesh, at most 1.8 times the largest distance of two vertices.
/// Requires:   a closed mesh, every facet of which is simple.
/// Exactness:  whether it is 0, and whether it is too much, is decided exactly; the number is off by a relative 1e-6.
/// Cost:       O(facets times vertices) where it is convex; else mostly far less.
std::optional<double> deviation_from_convex(std::span<const Point3> vertices,
                                            std::span<const std::vector<std::uint32_t>> facets);

}  // namespace gnomon
