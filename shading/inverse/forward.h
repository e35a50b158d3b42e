#pragma once

#include <optional>

#include "gnomon/light_design.h"

namespace gnomon::inverse {

/// What a subject receives of a light behind obstacles: asked of the visibility of points and the division of
/// receivers, which know nothing of goals. A polygon is lit, in umbra or unlit if almost all of it is, else in
/// penumbra: a part of it at least.
///
/// Returns: nothing for polygons that cannot be divided.
std::optional<Region> forward_region(const Light& light, const DesignSubject& subject, const Obstacles& obstacles);

/// The obstacles that count for a goal, without those that are left out.
Obstacles obstacles_that_count(const DesignGoal& goal, const DesignObstacles& obstacles,
                               const std::string& left_out = {});

/// The obstacle moved by a vector, each coordinate rounded.
ConvexBlocker moved(const ConvexBlocker& blocker, const Point3& by);

/// The light that a design speaks of at a position of its variable.
Light placed_light(const Design& design, const DesignGoal& goal, const Point3& position);

/// What stands in its way there: with the moved blocker moved.
Obstacles placed_obstacles(const Design& design, const DesignGoal& goal, const DesignObstacles& obstacles,
                           const Point3& position);

}  // namespace gnomon::inverse
