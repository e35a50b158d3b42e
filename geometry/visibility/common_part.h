#pragma once

/// Private to geometry/visibility.

#include <span>

#include "geometry/visibility/blocker_content.h"

namespace gnomon::viewpoint {

/// True if the blocker holds a point of the hull of a few points in one plane: a point, a segment's ends, a triangle's
/// corners, in any order around it. Both are closed.
///
/// Exactness: rational arithmetic; meant for the few cases that doubles leave open.
bool have_common_point(const BlockerSet::Content& blockers, std::uint32_t blocker, std::span<const Point3> hull);

}  // namespace gnomon::viewpoint
