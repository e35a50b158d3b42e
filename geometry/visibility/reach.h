#pragma once

#include <span>

#include "gnomon/blocker.h"

namespace gnomon {

/// False only if the blocker hides none of the light's hull from p: because some facet plane has p on its outer side
/// and all light points there too or on it, or some plane through p and an edge has the blocker on one side and all
/// light points strictly on the other. A quick test, on input points.
///
/// Exactness: signs of orientation determinants of input points; true may be more than needed, false never.
/// Cost:      O(number of vertices times number of light points).
bool may_hide(const ConvexBlocker& blocker, const Point3& p, std::span<const Point3> light);

}  // namespace gnomon
