#pragma once

#include <string>
#include <vector>

#include "apps/laws/census.h"
#include "apps/laws/example.h"
#include "apps/laws/law.h"
#include "geometry/spatial/convex_blocker.h"
#include "geometry/spatial/light.h"

namespace gnomon::laws {

enum class LightKind { point, direction, segment, one_sided_polygon, two_sided_polygon, rounded_polygon };
enum class BlockerKind { flat_polygon, solid, rounded_polygon };

/// A light and a blocker wherever they stand, and points.
struct AnyPair {
  Light light;
  ConvexBlocker blocker;
  std::vector<Point3> points;
};

/// The pair as text from which it can be built again: 17 digits, every vertex.
std::string description(const AnyPair& pair);

/// The case as a scene.
Example example(const AnyPair& drawn);

/// Adds the regions of the pair and that of the first point to the counts.
void count_regions(const AnyPair& drawn, Census& census);

/// Draws a pair with small integer coordinates, so that the two touch, cross, share elements and lie in common planes
/// in a good part of the cases; bent toward degeneracy by ulps, offsets and scales in the near-degenerate domain.
/// Points lie anywhere, on lines through both and their ends, on planes through edges, on the blocker.
///
/// Requires: called inside rc::gen::exec.
AnyPair draw_any_pair(Domain domain, LightKind light, BlockerKind blocker, int points);

}  // namespace gnomon::laws
