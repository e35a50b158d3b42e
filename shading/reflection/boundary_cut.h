#pragma once

/// The boundary of what the fast level sees, cut at the horizon and at R's plane. Private to the libraries.

#include <optional>

#include "geometry/visibility/fast_visibility.h"
#include "shading/reflection/area_forms.h"

namespace gnomon::shading {

/// Definition: pieces, or parts of them, below a plane are replaced by their shadows on it, along one direction for
/// all.
///             That direction does not lead below the light's plane or the horizon, so what is visible is only folded
///             onto the plane: pieces need not be in order.
/// Returns:    nothing where doubles do not tell on which side an end lies, or nothing of the light can be above.
std::optional<VisibleBoundary<Bounded>> cut_boundary(const VisibleAreaLight& seen, const Directions<Bounded>& view);

}  // namespace gnomon::shading
