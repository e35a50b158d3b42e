#pragma once

/// What a point sees of an area light, from the definition: the light is split along every plane, and the pieces that
/// no blocker hides are added up. Rational, quadratic, and without anything in common with the walk it judges.

#include <span>
#include <vector>

#include "apps/proof/laws/exact.h"
#include "geometry/numbers/kernel.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"
#include "gnomon/names.h"

namespace gnomon::test_support {

struct SplitView {
  Region region;
  Rational fraction;
  std::vector<std::vector<laws::ExactVector>> visible;  ///< convex pieces of positive area, each in either order
};

/// Requires: a flat light.
SplitView split_view(const AreaLight& light, std::span<const ConvexBlocker> blockers, const Point3& point);

}  // namespace gnomon::test_support
