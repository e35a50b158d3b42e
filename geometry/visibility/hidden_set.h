#pragma once

#include <vector>

#include "geometry/spatial/convex_blocker.h"
#include "geometry/visibility/exact_vector.h"

namespace gnomon {

/// A half-space of light points: those below a plane.
struct HidingCondition {
  enum class Boundary { belongs, excluded };

  ExactPlane plane;   ///< the half-space is where its height is negative
  Boundary boundary;  ///< whether the plane itself belongs to it
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

/// True if a point of light fulfils all conditions.
bool hides(const std::vector<HidingCondition>& conditions, const ExactVector& l);

/// True if a light infinitely far away, against `direction`, fulfils all conditions: the open ray meets the blocker.
bool hides_direction(const std::vector<HidingCondition>& conditions, const ExactVector& towards_light);

}  // namespace gnomon
