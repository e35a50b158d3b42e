#pragma once

#include "gnomon/light_design.h"
#include "shading/inverse/design_space.h"

namespace gnomon::inverse {

/// The shifts of a light of fixed shape, its scales, or the shifts of a blocker that a goal's subject leaves.
///
/// Definition: a light moved by t darkens a point if all its corners, moved, lie in the point's dark cone; it is lit
///             while light and cone have no interior point in common, which is a sum of two convex sets. A blocker
///             moved by v darkens a polygon if it meets all segments from corner to corner of both.
/// Throws:     DesignError for what is not supported.
void add_moved_sets(DesignSpace& space, const Design& design, std::uint32_t goal, const DesignSubject& subject,
                    const DesignObstacles& obstacles, GoalSets& sets);

}  // namespace gnomon::inverse
