#pragma once

/// What two surfaces exchange that see each other wholly. Private to the libraries.

#include <span>
#include <vector>

#include "gnomon/point.h"
#include "shading/reflection/bounded.h"

namespace gnomon::illumination {

/// The boundary of a flat piece of a surface, as loops: counterclockwise seen from its front, holes clockwise.
using Loops = std::vector<std::vector<Point3>>;

/// The area of one surface times the view factor from it to another that nothing hides: as much from either side.
///
/// Definition: 1/(2 pi) times the integral over both boundaries of ln |p - q| dp . dq, which is that of
///             cos cos / (pi |p - q|²) over both areas.
/// Requires:   finite points; each surface lies in the closed half-space before the other.
/// Degenerate: surfaces may touch, in points and along edges.
/// Exactness:  with an error bound, for the points given. Two edges on one line and parallel ones are in closed form;
///             of others the inner integral is, the outer one is by Gauss's rule with a bound that is proven
///             beforehand.
/// Units:      area.
/// After:      [Sparrow63]; [ATAP] ch. 19.
shading::Bounded exchange_area(const Loops& first, const Loops& second);

}  // namespace gnomon::illumination
