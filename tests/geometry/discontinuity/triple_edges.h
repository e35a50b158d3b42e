#pragma once

/// Three edges in line (EEE events), told roughly: an oracle apart from closing_arcs.h.

#include <span>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/numbers/exact_vector.h"

namespace gnomon::event {

/// False only if no point of the face sees three edges in line, each of them of the light or of a different blocker
/// among `shapes`, so that the outlines cross pairwise there.
///
/// Definition: two edges cross as seen from a point if its planes through either one have an end of the other strictly
///             on each side. They do so from no point of the face's hull if for one of them both ends of the other lie
///             on one closed side, for all of the face's vertices.
/// Exactness: rational arithmetic. Cost: quadratic in the number of edges.
bool may_have_triple_edges(const EventScene& scene, std::span<const ShapeId> shapes, std::span<const ExactVector> face);

}  // namespace gnomon::event
