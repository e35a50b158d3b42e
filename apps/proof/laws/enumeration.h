#pragma once

/// All extremal planes of a pair, found by trying every plane through an edge and a vertex.

#include "apps/proof/laws/exact.h"
#include "gnomon/pair.h"

namespace gnomon::laws {

/// One straight side of a polygon, with all vertices and edges on it.
struct PolygonSide {
  ExactVector from;
  ExactVector to;
  std::uint32_t lowest_edge = 0;
};

/// The sides of a flat polygon from corner to corner, in the order of the corners.
std::vector<PolygonSide> sides(const std::vector<ExactVector>& polygon);

/// The extremal planes named as ExtremalPlanes promises; the two planes through a linear light in the order of the
/// blocker vertices.
///
/// Requires: stands_apart(light, blocker).
/// Cost:     cubic.
ExtremalPlanes enumerated_planes(const Light& light, const ConvexPolygon& blocker);

/// What the separating planes add up from.
struct PlaneCounts {
  std::size_t blocker_sides = 0;
  std::size_t light_sides = 0;     ///< 2 for a linear light whose line misses the blocker; 0 if it hits it
  std::size_t coplanar_pairs = 0;  ///< pairs of such a light side and a blocker side in one separating plane
};

/// Requires: stands_apart(light, blocker).
PlaneCounts plane_counts(const Light& light, const ConvexPolygon& blocker);

}  // namespace gnomon::laws
