#pragma once

#include <optional>

#include "gnomon/light.h"
#include "gnomon/point.h"

namespace gnomon {

/// The flux [W] of a light of a strength, in all directions: none of a directional light, nor where
/// it exceeds the range of doubles.
///
/// Definition: pi times radiance times area, of both sides if two-sided; 4 pi times the intensity of a point; of a
///             linear light its length times the integral of k cos^(m+1)(beta) between the flaps, times the angle of
///             its half-planes, which is 2 pi without `shade`: 4 pi k alike everywhere, pi² k for m = 1.
/// Exactness:  off by less than 1e-12 of itself.
/// After:      [P93] §3.2.2, which keeps 4 pi k for m = 1.
std::optional<double> light_flux(const Light& light, double strength, const LengthUnit& unit);

}  // namespace gnomon
