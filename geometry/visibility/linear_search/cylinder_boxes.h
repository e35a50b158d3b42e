#pragma once

/// Private to geometry/visibility.

#include <vector>

#include "geometry/visibility/blocker_set.h"
#include "geometry/visibility/linear_search/light_cylinder.h"

namespace gnomon::viewpoint {

/// The box about the light of every blocker.
std::vector<CylinderBox> cylinder_boxes(const LightCylinder& cylinder, const BlockerSet::Content& blockers);

}  // namespace gnomon::viewpoint
