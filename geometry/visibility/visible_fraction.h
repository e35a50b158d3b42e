#pragma once

#include <optional>

#include "geometry/visibility/visible_part.h"

namespace gnomon {

/// The share of a light that is visible, by length or area; for point and directional lights 1 or 0.
struct VisibleFraction {
  double nearest = 0;             ///< correctly rounded where `exact` is given
  double error_bound = 0;         ///< at least the distance of `nearest` from the true value
  std::optional<Rational> exact;  ///< nothing where square roots remain: a rounded polygon seen in part
};

/// The visible fraction of a light.
///
/// Requires:  `part` was made of this light.
/// Returns:   0 for an unlit point.
/// Exactness: where square roots of areas remain they are enclosed to a relative 2^-190.
VisibleFraction visible_fraction(const VisiblePart& part);

}  // namespace gnomon
