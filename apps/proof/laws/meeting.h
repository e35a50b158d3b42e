#pragma once

/// Where a light and a blocker meet, decided from the points of both.

#include <optional>

#include "apps/proof/laws/visibility_definition.h"

namespace gnomon::laws {

/// The vertices of a light that is not directional.
std::vector<ExactVector> vertices_of(const Light& light);
std::vector<ExactVector> vertices_of(const ConvexBlocker& blocker);

/// True if the point is one of the blocker's.
bool holds(const Walls& blocker, const ExactVector& p);

/// True if the blocker has a point in the convex polygon, which may have shrunk to a segment or a point. Both are
/// closed.
bool meet(const std::vector<ExactVector>& polygon, const Walls& blocker);

/// True if the light meets the blocker in a part that can be measured: an area of a polygon, a length of a segment, a
/// point light itself.
///
/// Requires: an area light is flat.
bool meet_measurably(const Light& light, const Walls& blocker);

/// The plane of a flat one-sided light, its front positive; nothing for other lights.
std::optional<ExactPlane> front_of(const Light& light);

/// The plane of a flat blocker; nothing for a solid.
std::optional<ExactPlane> plane_of(const ConvexBlocker& blocker);

/// True if the two lie in one plane.
bool are_coplanar(const Light& light, const ConvexBlocker& blocker);

/// True if the blocker has points strictly in front of the light; always if it has no front.
bool reaches_front(const Light& light, const ConvexBlocker& blocker);

/// True if some direction other than zero leads from every one of the points, along a ray, to a point of the blocker,
/// and does not lead away from the front of the plane, if there is one.
///
/// Requires: at least one point; none is a point of the blocker.
bool parallel_rays_meet(const std::vector<ExactVector>& points, const std::vector<ExactVector>& blocker,
                        const std::optional<ExactPlane>& front);

}  // namespace gnomon::laws
