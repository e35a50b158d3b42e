#pragma once

#include <optional>
#include <vector>

#include "geometry/planar/exact_polygon.h"
#include "gnomon/flatland.h"
#include "gnomon/names.h"

namespace gnomon::planar {

/// Which events are wanted.
enum class EventDetail {
  regions,    ///< those at which a point can change between lit, penumbra and umbra
  structure,  ///< all at which what is visible, by names, changes
};

/// A part of the line through two event points along which what is visible of the light changes: it begins at the
/// farther point and runs away from the light.
struct EventRay {
  EventPoint near;  ///< the point nearer to the light, or on it
  EventPoint far;   ///< where the ray begins: a blocker's end
  ExactPoint near_point;
  Point2 far_point;
  Contact contact;                    ///< separating: what the two hide lies on opposite sides of the line
  std::optional<std::uint32_t> stop;  ///< a blocker across the ray; what lies beyond sees nothing of the light there
};

/// The event rays that reach the light: between a ray and the light no blocker crosses the line from side to side.
///
/// Definition: event points are the light's ends, the blockers' ends, and where a blocker crosses the light.
/// Returns:    every part of a line through two event points that bounds a region, and perhaps others: an event is
///             kept where it is doubtful whether what is hidden there changes.
/// Exactness:  what is left out is left out by exact signs.
/// Cost:       O(n²) for the lines, O(n) more for each that hits the light.
/// After:      [P93] §4.2.2.
std::vector<EventRay> event_rays(const Flatland& flatland, EventDetail detail);

}  // namespace gnomon::planar
