#pragma once

#include <span>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {

/// The vertices of a light; none for a directional light.
std::vector<Point3> light_points(const Light& light);

/// The vertices of a blocker.
std::span<const Point3> blocker_points(const BlockerShape& shape);

}  // namespace gnomon
