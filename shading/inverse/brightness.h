#pragma once

#include <span>

#include "gnomon/light_design.h"
#include "shading/inverse/design_space.h"

namespace gnomon::inverse {

/// A point with a normal, and the irradiance that it wants of a point light of intensity 1.
struct BrightPoint {
  Point3 point;
  ExactVector normal;
  double wanted = 1;  ///< positive
};

/// A position, and how bright it makes all points.
struct BrightestPosition {
  ExactVector position;
  double share = 0;  ///< the least irradiance of all points there, as a share of what each wants: a lower bound
  double most = 0;   ///< no position of the cells makes that share larger than this
};

/// The position of a point light that makes the darkest of some points as bright as can be, where nothing hides it.
///
/// Definition: in the cell that has the largest share; E = (N · v) / (|N| |v|³), v leading from the point to the light.
/// Method:     E^(-1/2) is convex in the light's position, so tangents are lower bounds everywhere: planes are cut, the
///             lowest point of all is the next to look at, until the bounds meet within 1e-9 of each other.
/// Exactness:  cuts are lowered by more than doubles can be off; the linear programs are rational, and the position
/// lies
///             in its cell exactly.
/// Requires:   bounded cells, in the closed front of every point.
BrightestPosition brightest_position(DesignSpace& space, std::span<const Cell> cells,
                                     std::span<const BrightPoint> points);

/// The points of a goal's subjects at which a point light's irradiance is least on them: their corners, as on a plane
/// it falls with the distance. Each wants what the goal does; 1 if that is not irradiance.
///
/// Requires: subjects with a front.
std::vector<BrightPoint> bright_points(const DesignGoal& goal);

/// The irradiance of a point by a light of intensity 1, unhidden; 0 behind it. Right to 2^-49 of itself.
double unit_irradiance(const BrightPoint& point, const ExactVector& position);

/// True if a point light at the position gives a point at least what it wants, unhidden: a sign of rational numbers.
bool is_bright_enough(const BrightPoint& point, const ExactVector& position);

}  // namespace gnomon::inverse
