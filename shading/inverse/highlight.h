#pragma once

#include <optional>

#include "geometry/numbers/exact_vector.h"
#include "gnomon/light_design.h"

namespace gnomon::inverse {

/// The direction from a point towards the light whose mirror image an eye sees there: 2 (n · e) n - (n · n) e, e being
/// the way to the eye; its length says nothing. Nothing if the eye does not lie before the point.
///
/// After: [P93] 5.2.2, with N in the middle between light and eye.
std::optional<ExactVector> mirror_direction(const ExactVector& normal, const ExactVector& eye);

/// Phong's exponent n with (R · L)^n = threshold at a point, R being the mirrored way to the eye.
///
/// Returns: with its bound; nothing unless 0 < R · L < 1.
/// Note:    ill-conditioned near the peak: an angle between R and L that is wrong by a share x makes n wrong by 2 x.
/// After:   [P93] (5.13).
std::optional<BoundedNumber> phong_exponent(const ExactVector& normal, const ExactVector& eye, const ExactVector& light,
                                            double threshold);

}  // namespace gnomon::inverse
