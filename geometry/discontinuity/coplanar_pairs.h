#pragma once

/// Two edges in one plane of which a point may see the middles in line, but no end. Private to this folder.

#include <cstddef>
#include <functional>

#include "geometry/discontinuity/wedge.h"

namespace gnomon::event {

/// How many sources the wedges of for_each_coplanar_wedge have: edges, then facets whose planes cut the light.
std::size_t coplanar_source_count(const EventScene& scene);

/// Calls `take` with the wedges of one source in the common planes of two edges: of a blocker's edge and one of the
/// light, of the edges of two blockers, of a facet's edge and what its plane cuts out of the light.
///
/// Definition: what a point of the plane sees of both in line with the light ends at an end of either edge, where the
///             plane leaves the light, or at a third blocker. The ends of edges make wedges of their own; the apex of
///             these is one of the other places. Each holds lines that meet both edges only.
/// Exactness:  exact; the apex bears homogeneous coordinates where it is no point of the input.
/// Cost:       for each edge one search with the hull of it and the light, for each pair in a plane that cuts the light
///             one along the plane.
/// After:      `scene` is as before; points are added for the time of a call only.
void for_each_coplanar_wedge(EventScene& scene, std::size_t source, const std::function<void(const Wedge&)>& take);

}  // namespace gnomon::event
