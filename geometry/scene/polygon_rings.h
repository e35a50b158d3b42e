#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gnomon/point.h"

namespace gnomon {

/// A closed boundary: indices of points, in order around it.
using Ring = std::vector<std::uint32_t>;

/// All indices below n.
Ring whole_ring(std::size_t n);

/// The ring without the vertices that equal the one before them, the first one after the last.
Ring without_repeats(std::span<const Point3> points, const Ring& ring);

/// What is left of a ring without the edges that it runs along both ways: seams that lead to holes and back, spikes.
/// Vertices of equal coordinates count as one, called by the lowest index among them; an edge through other vertices of
/// a ring with seams ends at each of them.
///
/// Returns: rings without a vertex in common, which run the same way as before; none if every edge goes both ways;
///          nothing if an edge runs twice the same way, or rings meet at a vertex.
std::optional<std::vector<Ring>> without_seams(std::span<const Point3> points, const Ring& ring);

/// Puts the outer ring first, as seen along an axis: that of the lowest vertex.
///
/// Requires: rings that do not cross, one of which encloses the others.
void put_outer_ring_first(std::span<const Point3> points, int dropped_axis, std::vector<Ring>& rings);

/// The points of all rings, one ring after the other.
std::vector<Point3> points_of_rings(std::span<const Point3> points, std::span<const Ring> rings);

}  // namespace gnomon
