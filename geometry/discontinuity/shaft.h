#pragma once

/// The hull of some points and the light, roughly. Private to this folder.

#include <span>
#include <vector>

#include "geometry/discontinuity/event_scene.h"

namespace gnomon::event {

/// Half-spaces that hold every segment from one of the points to the light. The points may be off by 2^-48 of the
/// largest coordinate. Exactness: conservative.
std::vector<RoughHalfSpace> shaft(const EventScene& scene, std::span<const Point3> points);

}  // namespace gnomon::event
