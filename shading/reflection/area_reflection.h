#pragma once

/// What a surface reflects of an area light. Private: polygons are rational.

#include <span>

#include "geometry/visibility/fast_visibility.h"
#include "geometry/visibility/visible_part.h"
#include "shading/reflection/sight.h"

namespace gnomon::shading {

/// Of what the fast level sees, radiance 1: in doubles, or nothing where they do not decide or have no narrow bound.
/// Requires: the eye above the surface.
std::optional<Reflection> area_reflection(const LightSeen& seen, const Sight& sight);

/// Of visible polygons. Cuts are exact, then precision rises until it suffices. A facet that turns its back gives
/// nothing.
Reflection area_reflection(std::span<const SeenFacet> facets, bool two_sided, const Sight& sight);

}  // namespace gnomon::shading
