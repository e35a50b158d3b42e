#pragma once

/// Whether light passes beside a shape on its way to a face, by intervals. Private to this folder.

#include <optional>
#include <span>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/silhouette_edges.h"

namespace gnomon::event {

/// Whether a flat shape hides a point of light from no point of the hull of some others, because a plane parts them:
/// that of the shape, or one through the point and a side. Nothing if intervals do not tell, and of a solid.
///
/// Requires: the rounding mode is protected.
std::optional<bool> certainly_passes(const EventScene& scene, const Shape& shape, const Place& light,
                                     std::span<const Place> face);

}  // namespace gnomon::event
