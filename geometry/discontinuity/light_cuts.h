#pragma once

/// Where blockers meet the light. Private to this folder.

#include <array>
#include <optional>
#include <vector>

#include "geometry/discontinuity/event_scene.h"

namespace gnomon::event {

/// A point or segment of the light in which a blocker meets it.
struct LightCut {
  std::array<EventPoint, 2> ends;  ///< two different points; of a linear light twice the same
};

/// Where blockers pass through the light, or touch it with an edge or a facet that does not lie in one plane with it.
///
/// Requires:  an area or linear light.
/// Exactness: exact; the points bear homogeneous coordinates.
std::vector<LightCut> light_cuts(const EventScene& scene);

/// Where blockers touch an area light in a point: with a vertex, or at its outline. Each once, without vertices of the
/// light and ends of cuts. A blocker that touches a linear light in a point has a plane there that cuts it, or hides
/// nothing.
/// Exactness: as above.
std::vector<EventPoint> light_touches(const EventScene& scene, const std::vector<LightCut>& cuts);

/// The points in which the plane of a loop cuts the light's outline, if it leaves vertices of the light on both sides.
/// Requires, Exactness: as above.
std::optional<LightCut> plane_cut(const EventScene& scene, const std::vector<PointId>& loop);

}  // namespace gnomon::event
