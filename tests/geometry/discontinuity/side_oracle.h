#pragma once

/// The region of a point of a receiver that has a side, from the definition: the oracle of receivers' labels.

#include <span>

#include "geometry/numbers/exact_vector.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"
#include "gnomon/names.h"

namespace gnomon::test_support {

/// The region of a point p of a plane whose normal N points to the receiver's front.
///
/// Definition: of the light counts what lies strictly before the plane. One of its points l is hidden if for all small
///             e > 0 the open segment from p + e N to l meets a blocker; for a direction, the open ray. Unlit where
///             nothing counts, or the light shows its back or edge; else lit where the hidden points have no measure,
///             umbra where the others have none.
/// Method:     the light is split by every plane that holds p and an edge of a blocker, or a facet; a point inside each
///             piece tells all of it. The segment is clipped by the blocker's walls, in numbers a + b e + c e² of an
///             infinitesimal e. No outline, no event, no hidden set.
/// Requires:   p lies on no side of what blockers have in the plane; a flat area light.
Region region_before_plane(const Light& light, std::span<const ConvexBlocker> blockers, const ExactVector& normal,
                           const ExactVector& p);

}  // namespace gnomon::test_support
