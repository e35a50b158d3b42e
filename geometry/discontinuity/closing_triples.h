#pragma once

/// Which three edges may come in line where the last gap of light in a face closes. Private to this folder.

#include <span>
#include <vector>

#include "geometry/discontinuity/silhouette_edges.h"

namespace gnomon::event {

/// Three edges, by their indices, ascending: those of the light come first.
using EdgeTriple = std::array<std::uint32_t, 3>;

/// All triples of edges but those that no point of a face sees close a gap: two of them do not cross; or one is no part
/// of an outline; or what they leave open has a direction in common. For the rest see closing_arcs.h.
/// Parameters: corners  in whose convex hull the face lies.
/// Exactness:  intervals, and exact arithmetic where these do not tell.
std::vector<EdgeTriple> closing_triples(const NumberedSilhouettes& silhouette_edges, std::span<const Place> corners,
                                        bool is_linear);

}  // namespace gnomon::event
