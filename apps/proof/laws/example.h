#pragma once

#include <span>
#include <string>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/flatland.h"
#include "gnomon/light.h"
#include "gnomon/scene.h"

namespace gnomon::laws {

/// A case as a scene that can be written and drawn, and the points the case is about; in the plane they have z = 0.
struct Example {
  Scene scene;
  std::vector<Point3> points;
};

/// A scene of one light, named `light`, and blockers `blocker_0`, `blocker_1`, ...
Example spatial_example(const Light& light, std::span<const ConvexBlocker> blockers, std::vector<Point3> points);

/// The same in the plane.
Example planar_example(std::span<const Point2> light, std::span<const planar::BlockerSegment> blockers,
                       std::span<const Point2> points);

}  // namespace gnomon::laws
