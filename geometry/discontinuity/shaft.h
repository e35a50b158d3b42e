#pragma once

/// The hull of some points and the light, roughly. Private to this folder.

#include <span>
#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/visibility/exact_vector.h"

namespace gnomon::event {

/// Half-spaces that hold every segment from one of the points to the light.
/// Exactness: conservative.
std::vector<RoughHalfSpace> shaft(const EventScene& scene, std::span<const ExactVector> points);

}  // namespace gnomon::event
