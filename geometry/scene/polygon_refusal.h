#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "gnomon/convex_polygon.h"
#include "gnomon/point.h"

namespace gnomon {

/// Why a list of vertices is refused, in the words of a message.
struct PolygonRefusal {
  std::optional<std::uint32_t> vertex;  ///< the vertex at fault; nothing if it is the list as a whole
  std::string found;
  std::string expected;
};

/// Refusals of single kinds: of a list of so many vertices, of a vertex that repeats another, of vertices on one line.
PolygonRefusal too_few_refusal(std::size_t count);
PolygonRefusal repeated_refusal(std::span<const Point3> points, std::uint32_t vertex, std::uint32_t other);
PolygonRefusal collinear_refusal();

/// Of vertices near one plane, whose boundary is not convex.
PolygonRefusal convexity_refusal(std::span<const Point3> points, const PolygonDefect& defect);

/// The point as messages print it: (0, 1.5, 2).
std::string point_text(const Point3& point);

}  // namespace gnomon
