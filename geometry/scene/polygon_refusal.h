#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "geometry/point.h"

namespace gnomon {

/// Why a list of vertices is refused, in the words of a message.
struct PolygonRefusal {
  std::optional<std::uint32_t> vertex;  ///< the vertex at fault; nothing if it is the list as a whole
  std::string found;
  std::string expected;
};

/// Nothing if the points are the vertices of a convex polygon.
std::optional<PolygonRefusal> convex_polygon_refusal(std::span<const Point3> points);

/// Nothing if the points are the vertices of a simple polygon, convex or not, coplanar up to rounding.
/// `deviation` receives the largest distance from its plane, 0 if it is exactly coplanar.
std::optional<PolygonRefusal> simple_polygon_refusal(std::span<const Point3> points, double& deviation);

/// The point as messages print it: (0, 1.5, 2).
std::string point_text(const Point3& point);

}  // namespace gnomon
