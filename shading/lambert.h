#pragma once

#include "geometry/visibility/fast_visibility.h"
#include "gnomon/irradiance.h"

namespace gnomon {

/// Irradiance that a diffuse area light of the given radiance gives to a receiver at the point that looked.
///
/// Definition: (R/2) times the sum, over the boundary of what is visible above the receiver's horizon, of the angle
///             under which a piece is seen times the cosine between the receiver's normal and the piece's plane.
/// Requires:   `normal` is finite and not zero; its length does not matter.
/// Returns:    0 where nothing is visible; never negative.
/// Degenerate: a piece that passes below the horizon is replaced there by its shadow on the horizon, along one
///             direction for all pieces. So nothing is decided about the horizon: the sum depends continuously on every
///             vertex.
/// Exactness:  with an error bound. It grows where pieces come near half a turn, as seen from very close to the light.
/// Units:      radiance in W/(m² sr), irradiance in W/m².
/// After:      [P93] §3.2, [CF91] §4.3.
Irradiance lambert_irradiance(const VisibleAreaLight& seen, const Point3& normal, double radiance);

}  // namespace gnomon
