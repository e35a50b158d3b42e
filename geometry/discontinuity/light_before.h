#pragma once

/// What of a light a receiver can receive. Private to this folder.

#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_plane.h"

namespace gnomon::event {

/// What of the light lies strictly before a receiver's plane, called L+, and its closure.
struct LightBefore {
  struct Corner {
    ExactVector point;  ///< of a direction the way towards the light
    int height = 0;     ///< +1 before the plane, 0 in it
    EventElement edge;  ///< an edge of the light that ends or passes through the plane there
  };

  std::vector<int> sides;       ///< of the receiver's plane, for each light vertex
  std::vector<Corner> corners;  ///< of the closure of L+: of an area light in order; none if L+ is empty

  bool is_empty() const { return corners.empty(); }
  /// All of the light lies strictly before the plane.
  bool is_whole() const;
};

/// Requires: the rounding mode is protected. Exactness: exact.
LightBefore light_before(const EventScene& scene, const Shape& receiver, const ReceiverPlane& plane);

}  // namespace gnomon::event
