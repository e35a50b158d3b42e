#pragma once

#include <span>

#include "geometry/bodies/body.h"
#include "gnomon/scene.h"

namespace gnomon {

/// The vertices of a blocker.
std::span<const Point3> blocker_points(const BlockerShape& shape);

}  // namespace gnomon
