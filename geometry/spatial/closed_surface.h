#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.h"

namespace gnomon {

/// A surface without boundary, made of triangles: every edge runs as often one way as the other.
struct ClosedSurface {
  std::vector<Point3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices
};

/// True if the surface winds around the point: the point lies strictly inside what the surface encloses, whichever
/// way its triangles run. A cavity is outside, what two overlapping shells share is inside.
///
/// Degenerate: false on the surface itself. Triangles without area are harmless.
/// Exactness:  signs of orientation determinants of input points.
/// Cost:       O(number of triangles).
bool is_strictly_inside(const Point3& point, const ClosedSurface& surface);

}  // namespace gnomon
