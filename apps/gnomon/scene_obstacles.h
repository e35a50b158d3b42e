#pragma once

#include "geometry/scene/scene.h"
#include "geometry/visibility/light_visibility.h"

namespace gnomon {

/// Every blocker of a scene of space in convex parts, and what its closed meshes enclose.
Obstacles obstacles_of(const Scene& scene);

/// The same, ready for many points.
PreparedObstacles scene_obstacles(const Scene& scene);

}  // namespace gnomon
