#pragma once

/// Irradiance of lights without area. Private: intervals are rational.

#include <array>
#include <span>

#include "geometry/numbers/kernel.h"
#include "geometry/visibility/fast_linear_visibility.h"
#include "gnomon/irradiance.h"
#include "gnomon/light.h"

namespace gnomon {

/// Irradiance of a visible point light of intensity 1: cosine over squared distance, 0 below the horizon.
/// Degenerate: infinite at the light itself.
Irradiance point_irradiance(const PointLight& light, const Point3& p, const Point3& normal);

/// Irradiance of a visible directional light that gives 1 to a surface it meets perpendicularly: the cosine.
Irradiance directional_irradiance(const DirectionalLight& light, const Point3& normal);

/// Irradiance of the visible intervals of a linear light of intensity 1 per length: the integral of cosine over squared
/// distance over what lies above the horizon.
///
/// Degenerate: infinite at a visible point of the light.
/// Exactness:  the ends are exact, the horizon's among them, before they are rounded. With an error bound.
/// After:      [PA90] §3, in closed form.
Irradiance linear_irradiance(const LinearLight& light, std::span<const std::array<Rational, 2>> intervals,
                             const Point3& p, const Point3& normal);

/// The same of what the fast level sees: in doubles, with an error bound that may be infinite.
///
/// Requires: p off the light's line.
Irradiance linear_irradiance(const LinearLight& light, const VisibleLinearLight& seen, const Point3& p,
                             const Point3& normal);

}  // namespace gnomon
