#pragma once

#include <variant>

#include "geometry/spatial/convex_polygon.h"
#include "geometry/spatial/convex_solid.h"

namespace gnomon {

/// An opaque convex set of space: a flat polygon, which hides from both sides, or a solid.
/// A polygon in here is exactly flat.
using ConvexBlocker = std::variant<ConvexPolygon, ConvexSolid>;

/// The set that a polygon stands for: itself if it is flat, else the solid between its rounded vertices.
ConvexBlocker convex_blocker(const ConvexPolygon& polygon);

}  // namespace gnomon
