#pragma once

#include "gnomon/light_design.h"
#include "shading/inverse/design_space.h"

namespace gnomon::inverse {

/// The scales s > 0 of a light about a centre that a goal's subject leaves, as sets along the x-axis.
///
/// Definition: a scaled light stays in a dark cone while each of its corners does, which is a bound of s for each plane
///             and corner; the scales at which it reaches into an occlusion are an interval, between two linear
///             programs' values.
void add_scales(DesignSpace& space, const Design& design, std::uint32_t goal, const DesignSubject& subject,
                const DesignObstacles& obstacles, GoalSets& sets);

}  // namespace gnomon::inverse
