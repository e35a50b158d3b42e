#pragma once

#include <span>

#include "apps/proof/report/visibility_answer.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::report {

/// What a point sees of a light by CGAL's ready-made way: the flat blockers' shadows on the light's plane, taken away
/// from the light with Polygon_set_2 in exact arithmetic. Only the irradiance is evaluated in doubles.
///
/// Requires: a light in a plane of constant z that shines down; flat blockers, and they and the point below it in this
///           order; a light wholly above the receiver's horizon.
VisibilityAnswer polygon_set_visibility(const AreaLight& light, std::span<const ConvexBlocker> blockers,
                                        const Point3& p, const Point3& normal);

}  // namespace gnomon::report
