#pragma once

#include "gnomon/light_design.h"
#include "shading/inverse/design_space.h"

namespace gnomon::inverse {

/// The positions, directions or shifts that a goal leaves.
///
/// Definition: reciprocity (a point is hidden from another if and only if the other is hidden from it) makes each set a
///             shadow of the subject: for lights without size the subject's occlusions and umbrae themselves, for
///             others and for moved blockers sums of shapes.
/// Throws:     DesignError naming the goal for what is not supported.
GoalSets goal_sets(DesignSpace& space, const Design& design, std::uint32_t goal, const DesignObstacles& obstacles);

/// The numbers of the blocker's parts that count for a goal.
std::vector<std::uint32_t> parts_that_count(const DesignGoal& goal, const DesignObstacles& obstacles);

/// The subject as a light that shines from both sides.
Light as_light(const DesignSubject& subject);

/// The plane of an area light, through three of its corners; its normal points to the front.
ExactPlane plane_of(const AreaLight& light);

/// The half-space before a subject's front.
Whole front_plane(const DesignSubject& subject);

/// The blocker's points.
std::span<const Point3> points_of(const ConvexBlocker& blocker);

}  // namespace gnomon::inverse
