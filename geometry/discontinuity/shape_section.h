#pragma once

/// What the plane of a pencil cuts out of a shape. Private to this folder.

#include <vector>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/pencil.h"

namespace gnomon::event {

/// The section of a shape with a pencil's plane: the two ends of a segment, or the corners of a polygon in the order of
/// its boundary, one way round or the other.
///
/// Returns: false, unless corners lie strictly on both sides of the plane. A convex shape with none on one side has no
///          point of its inside in the plane, so it stops no line of the pencil.
bool section(Pencil& pencil, const Shape& shape, std::vector<NodeId>& nodes);

}  // namespace gnomon::event
