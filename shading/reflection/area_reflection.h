#pragma once

/// What a surface reflects of an area light. Private: polygons are rational.

#include <span>

#include "geometry/visibility/fast_visibility.h"
#include "geometry/visibility/visible_part.h"
#include "shading/reflection/reflection_query.h"

namespace gnomon::shading {

/// Of what the fast level sees, radiance 1: in doubles, or nothing where they do not decide or have no narrow bound.
/// Requires: the eye above the surface.
std::optional<Reflection> area_reflection(const VisibleAreaLight& seen, const ReflectionQuery& query);

/// Of visible polygons. Cuts are exact, then precision rises until it suffices. A facet that turns its back gives
/// nothing.
Reflection area_reflection(std::span<const VisibleFacet> facets, bool two_sided, const ReflectionQuery& query);

}  // namespace gnomon::shading
