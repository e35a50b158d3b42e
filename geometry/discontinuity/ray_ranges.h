#pragma once

/// Sets of lines of a pencil. Private to this folder.

#include <vector>

#include "geometry/discontinuity/pencil.h"

namespace gnomon::event {

/// The common part; false if it is a single line or nothing.
bool intersect(const Pencil& pencil, RayRange& range, const RayRange& other);

/// Removes the insides of `blocked` from `ranges`, which are disjoint and in order; single lines are left out.
void subtract(const Pencil& pencil, std::vector<RayRange>& blocked, std::vector<RayRange>& ranges);

}  // namespace gnomon::event
