#pragma once

#include <array>

#include "geometry/exact_number.h"
#include "geometry/spatial/shadow_volume.h"

namespace gnomon {

/// The bounding plane of a half-space as numbers a, b, c, d: the half-space is a x + b y + c z + d <= 0.
///
/// Definition: (a, b, c) is the cross product of the plane's two edges at its first point, so that it points out of the
///             half-space; its length says nothing. Where the largest of the four would not lie between 2^-900 and
///             2^900, as it does for scenes of usual sizes, all four are multiplied by the power of two that brings it
///             between 1/2 and 2, so that doubles hold it.
/// Exactness:  exact rationals, and each correctly rounded. Rounded alone, they no longer hold for every point.
std::array<ExactNumber, 4> plane_coefficients(const HalfSpace& half_space);

}  // namespace gnomon
