#pragma once

#include <optional>

#include "geometry/visibility/visible_part.h"

namespace gnomon {

/// The share of a light that is visible, by length or area; for point and directional lights 1 or 0.
struct VisibleFraction {
  double nearest = 0;             ///< the nearest double where `exact` is given, else that or its neighbour
  double error_bound = 0;         ///< at least the distance of `nearest` from the true value
  std::optional<Rational> exact;  ///< nothing where it was only enclosed
};

/// The visible fraction of a light.
///
/// Requires:  `part` was made of this light.
/// Returns:   0 for an unlit point.
/// Exactness: exact, but for rounded polygons, where square roots of areas are enclosed to a relative 2^-190, and for
///            more than 64 pieces, whose sum is enclosed to a relative 2^-300 of the largest.
VisibleFraction visible_fraction(const VisiblePart& part);

/// The share of the light that lies before the receiver: 1 for a bare point. Where the part is lit, its visible
/// fraction.
VisibleFraction fraction_before(const VisiblePart& part);

}  // namespace gnomon
