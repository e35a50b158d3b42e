#pragma once

#include <vector>

#include "gnomon/blocker.h"

namespace gnomon {

/// The vertices, in order, of the polygon that a thin solid stands for: one whose vertices were rounded off their
/// plane. None of other solids.
std::vector<Point3> plate_ring(const ConvexSolid& solid);

}  // namespace gnomon
