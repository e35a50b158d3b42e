#pragma once

#include <span>

#include "gnomon/light_design.h"
#include "shading/inverse/design_space.h"

namespace gnomon::inverse {

/// What becomes of a goal at a position: asked of visibility where that can answer, of the goal's sets elsewhere.
GoalOutcome goal_outcome(DesignSpace& space, const Design& design, std::uint32_t goal, const GoalSets& sets,
                         const DesignObstacles& obstacles, const Point3& position, const Cell& domain);

}  // namespace gnomon::inverse
