#pragma once

#include <span>
#include <string>
#include <vector>

#include "geometry/numbers/kernel.h"
#include "geometry/scene/polygon_rings.h"

namespace gnomon {

/// A closed boundary as it is seen along an axis.
using FlatRing = std::vector<InputKernel::Point_2>;

FlatRing seen_along(int dropped_axis, std::span<const Point3> points, const Ring& ring);

/// No two edges share more than the vertex between them.
bool is_simple(const FlatRing& ring);

/// Requires: a simple ring.
bool is_clockwise(const FlatRing& ring);

/// Two edges that share more than they may, called by their first vertices: "edges 0 and 2 meet".
///
/// Requires: a ring that is not simple; `names` are its vertices.
/// Cost:     O(n²), for messages only; very long rings are not searched.
std::string crossing_edges(const FlatRing& ring, const Ring& names);

}  // namespace gnomon
