#pragma once

#include <span>
#include <vector>

#include "gnomon/blocker.h"

namespace gnomon::report {

/// The same points of space as blockers with fewer corners each, for which the exact level is fast.
///
/// Definition: a flat polygon of n corners, n more than 64, becomes the polygon of every k-th corner, k about twice
///             the root of n, and the pieces that this cuts off, each of at most k + 1 corners. Nothing is constructed,
///             so the union is exactly the polygon and hides the same. Other blockers stay as they are.
std::vector<ConvexBlocker> divided(std::span<const ConvexBlocker> blockers);

}  // namespace gnomon::report
