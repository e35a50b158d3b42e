#pragma once

/// Discontinuities along lines of sight in the receiver's own plane. Private to this folder.

#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/light_before.h"
#include "geometry/discontinuity/plane_traces.h"
#include "geometry/discontinuity/receiver_plane.h"

namespace gnomon::event {

/// Appends to `segments`, not yet cut by the receiver, where points see along the receiver's plane two places in line
/// in which the light or blockers meet that plane, the light beyond.
///
/// Definition: the feet of light and blockers are what their closed parts before the plane have in it: a point, a
///             segment or, of a blocker, a polygon. A trace begins at the farther of two corners of different feet,
///             both on a line from the light's foot, and runs on until the line passes through the inside of a
///             blocker's foot, which hides the light just above it. Corners of the light's foot are its ends, and where
///             blockers' feet cross it. docs/receivers.md proves that with these no event of vertices and edges is
///             missing.
/// Exactness:  exact.
void append_horizon_traces(const EventScene& scene, std::uint32_t receiver, const ReceiverPlane& plane,
                           const LightBefore& light, std::vector<NamedSegment>& segments);

}  // namespace gnomon::event
