#pragma once

/// What a surface reflects of a linear light. Private: intervals are rational.

#include <array>
#include <span>

#include "geometry/visibility/fast_linear_visibility.h"
#include "gnomon/light.h"
#include "shading/reflection/reflection_query.h"

namespace gnomon::shading {

/// Of what the fast level sees: in doubles, or nothing where they do not decide or have no narrow bound.
/// Requires: the eye above the surface; the point off the light's line.
std::optional<Reflection> linear_reflection(const LinearLight& light, const VisibleLinearLight& seen,
                                            const ReflectionQuery& query);

/// Of visible intervals, shares of the way from start to end. Cuts are exact, then precision rises until it suffices.
/// Degenerate: infinite at a visible point of the light; seen end-on it is one direction.
Reflection linear_reflection(const LinearLight& light, std::span<const std::array<Rational, 2>> intervals,
                             const ReflectionQuery& query);

}  // namespace gnomon::shading
