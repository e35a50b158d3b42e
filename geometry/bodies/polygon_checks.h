#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "gnomon/point.h"

namespace gnomon {

/// A vertex that equals an earlier one.
struct RepeatedVertex {
  std::uint32_t vertex;
  std::uint32_t other;  ///< the first vertex of the same coordinates
};

/// The repeated vertex of lowest index, or nothing.
///
/// Cost: O(n log n).
std::optional<RepeatedVertex> repeated_vertex(std::span<const Point3> points);

/// How far the vertices of a polygon are from one plane, as a share of the largest distance of two of them. The limits
/// belong to the format of scene files; the deviation is compared with them exactly.
enum class Flatness {
  flat,     ///< exactly coplanar
  rounded,  ///< at most 1e-9 off: coordinates of a plane that were rounded to doubles
  bent,     ///< at most 1e-2 off: what float files, millimetre grids and measured rooms hold
  crooked,  ///< farther off
};

/// The plane that stands for the vertices of a polygon.
///
/// Definition: exactly coplanar vertices: their plane. Otherwise the plane through the first vertex p, the first vertex
/// a at least half as far from p as the farthest one, and the first vertex b whose triangle p, a, b has at least half
/// of the largest area. No vertex is then much farther from it than from the best plane there is, and for most
/// polygons it is the plane of the first three vertices.
struct PolygonPlane {
  int dropped_axis = 0;                     ///< 0, 1, 2 for x, y, z: leaving it out maps the plane one to one
  std::array<std::uint32_t, 3> vertices{};  ///< that span it, in order
  double deviation = 0;        ///< of `farthest`; relative error below 1e-12; 0 if and only if exactly coplanar
  std::uint32_t farthest = 0;  ///< the vertex farthest from the plane, of lowest index
  Flatness flatness = Flatness::flat;
};

/// The plane of the vertices, or nothing if they lie on one line.
///
/// Requires:  at least one point, all coordinates finite.
/// Exactness: the choice of the vertices, the deviation and its limit are compared exactly, whatever the magnitude.
/// Cost:      O(n) for coplanar vertices; otherwise exact arithmetic, and O(n²) where the deviation is near the limit.
std::optional<PolygonPlane> polygon_plane(std::span<const Point3> points);

/// True if one plane holds all the points, or one line or point does.
///
/// Exactness: signs of orientation determinants of input points.
bool are_coplanar(std::span<const Point3> points);

/// The point without one coordinate: (y, z), (z, x) or (x, y) for axis 0, 1, 2.
Point2 projected(const Point3& point, int dropped_axis);

}  // namespace gnomon
