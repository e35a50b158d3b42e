#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/numbers/kernel.h"
#include "gnomon/flatland_regions.h"

namespace gnomon::planar {

/// A point of the plane, constructed exactly.
struct ExactPoint {
  Rational x;
  Rational y;

  friend bool operator==(const ExactPoint&, const ExactPoint&) = default;
};

/// A bounded convex polygon with interior; empty lists: no interior.
/// Orientation: counterclockwise; side k runs from vertex k to vertex k + 1 and lies on the line that its name says.
struct ExactPolygon {
  std::vector<ExactPoint> vertices;
  std::vector<SideName> sides;
};

/// The part of a piece inside a box.
///
/// Requires: box.min < box.max in both coordinates.
ExactPolygon clipped(const Pair& pair, const ConvexPiece& piece, const Box2& box);

/// The part of the line through two different points inside a box, in the direction from `from` to `to`. Nothing if the
/// line misses the box or touches it in a point.
///
/// Requires: box.min < box.max in both coordinates.
std::optional<std::array<ExactPoint, 2>> clipped_line(const Point2& from, const Point2& to, const Box2& box);

/// Twice the area, exactly.
Rational twice_area(const ExactPolygon& polygon);

}  // namespace gnomon::planar
