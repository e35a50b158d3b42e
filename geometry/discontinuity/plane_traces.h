#pragma once

/// Discontinuities on a receiver that no vertex and edge in line make: contacts, and the light's plane.
/// Private to this folder.

#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_plane.h"

namespace gnomon::event {

/// A segment with the name of its event.
struct NamedSegment {
  FlatSegment segment;
  EventName name;
};

/// Appends to `segments`, not yet cut by the receiver:
/// - where blockers that reach before the receiver stand on it with a facet or an edge, or pass through it;
/// - where it meets the light's plane.
/// Exactness: exact.
void append_plane_traces(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane,
                         std::vector<NamedSegment>& segments);

}  // namespace gnomon::event
