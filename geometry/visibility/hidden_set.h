#pragma once

#include <vector>

#include "geometry/numbers/exact_vector.h"
#include "gnomon/blocker.h"

namespace gnomon {

/// A half-space of light points: those below a plane.
struct HidingCondition {
  enum class Boundary { belongs, excluded };

  ExactPlane plane;      ///< the half-space is where its height is negative
  Boundary boundary;     ///< whether the plane itself belongs to it
  ExactPlane then = {};  ///< of what lies in the plane: below this one, if it is one
};

/// A point, and a step from it that is as short as one likes: the limit of place + e step for e > 0 towards 0.
/// Without a step the point itself.
struct LimitPoint {
  ExactVector place;
  ExactVector step = {};
};

/// The points of light that a convex blocker hides from a point p, as an intersection of half-spaces.
///
/// Definition: l is hidden if the open segment (p, l) meets the blocker. Write the blocker as the set where functions
///             h_i are not positive. Along the segment each h_i is linear, so each bounds the part of the segment
///             inside: from below where h_i(p) > 0, from above where h_i(p) < 0 < h_i(l). That some part is left can be
///             told from pairs of bounds, and is linear in l: h_i(l) < 0 where h_i(p) > 0; h_i(l) <= 0 where h_i(p) =
///             0; and for h_i(p) > 0 > h_j(p), that l is not above the plane through p and the line h_i = h_j = 0. Of
///             the latter only those of neighbours bound.
/// Returns:    no condition where everything is hidden, that is from the inside of a solid.
/// Degenerate: every position of p: on a facet, an edge, a vertex, in a facet's plane. From a flat polygon's own plane
///             only what lies in that plane can be hidden.
/// A light point that equals p is not asked about.
std::vector<HidingCondition> hiding_conditions(const ConvexBlocker& blocker, const ExactVector& p);

/// The same as a limit: what is hidden from place + e step for all e > 0 that are small enough.
///
/// Definition: every h_i(p) and every plane through p is linear in e. So where a height is 0 its growth along the step
///             decides, and of what lies in a plane through p the plane's own growth, `then`.
std::vector<HidingCondition> hiding_conditions(const ConvexBlocker& blocker, const LimitPoint& p);

/// True if a point of light fulfils all conditions.
bool hides(const std::vector<HidingCondition>& conditions, const ExactVector& l);

/// True if a light infinitely far away, against `direction`, fulfils all conditions: the open ray meets the blocker.
bool hides_direction(const std::vector<HidingCondition>& conditions, const ExactVector& towards_light);

}  // namespace gnomon
