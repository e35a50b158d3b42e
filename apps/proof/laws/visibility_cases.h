#pragma once

#include <string>
#include <vector>

#include <rapidcheck.h>

#include "apps/proof/laws/census.h"
#include "apps/proof/laws/example.h"
#include "apps/proof/laws/law.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::laws {

/// A light, some blockers, and a point, standing to each other in any way.
struct VisibilityCase {
  Light light;
  std::vector<ConvexBlocker> blockers;
  Point3 point;
};

enum class LightKind { point, direction, segment, polygon, rounded_polygon };
enum class BlockerKind { polygon, solid, rounded_polygon };

/// What the cases are to hold.
struct VisibilityMix {
  std::vector<LightKind> lights;
  std::vector<BlockerKind> blockers;
  int most_blockers = 1;
};

/// The case as text from which it can be built again: 17 digits, every vertex.
std::string description(const VisibilityCase& drawn);

/// The case as a scene.
Example example(const VisibilityCase& drawn);

/// Adds the region of the point, and of a single blocker the regions of the pair to the counts.
void count_regions(const VisibilityCase& drawn, Census& census);

/// Cases of small integers in which everything degenerate is common: blockers and light share vertices, touch, cross,
/// lie in each other's planes; the point lies in a plane of three vertices, on a line of two, on a vertex, in the
/// light. Near degeneracy they are needles, far from the origin with small detail, shifted by little, or one ulp off.
rc::Gen<VisibilityCase> visibility_cases(Domain domain, const VisibilityMix& mix);

}  // namespace gnomon::laws
