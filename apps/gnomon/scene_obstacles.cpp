#include "apps/gnomon/scene_obstacles.h"

#include <utility>

#include "geometry/scene/convex_parts.h"

namespace gnomon {

Obstacles obstacles_of(const Scene& scene) {
  Obstacles obstacles;
  for (const SceneBlocker& blocker : scene.blockers) {
    for (ConvexPart& part : convex_parts(blocker)) obstacles.blockers.push_back(std::move(part.shape));
    if (auto space = enclosed_space(blocker)) obstacles.enclosures.push_back(std::move(*space));
  }
  return obstacles;
}

PreparedObstacles scene_obstacles(const Scene& scene) {
  return PreparedObstacles(obstacles_of(scene));
}

}  // namespace gnomon
