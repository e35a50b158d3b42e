#pragma once

/// @file
/// Convex polygons in space, checked exactly.
///
///     #include <gnomon/convex_polygon.h>
///     int main() {
///       using gnomon::ConvexPolygon, gnomon::PolygonDefect, gnomon::Point3;
///       const Point3 dented[] = {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
///       const auto defect = ConvexPolygon::defect(dented);  // the boundary turns back at vertex 2
///       const ConvexPolygon board = ConvexPolygon::from_points({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
///       return defect->kind == PolygonDefect::Kind::not_convex && defect->vertex == 2 && board.is_flat() ? 0 : 1;
///     }

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gnomon/point.h"

namespace gnomon {

/// Why a list of points is no convex polygon.
struct PolygonDefect {
  enum class Kind {
    too_few_vertices,  ///< fewer than 3
    repeated_vertex,   ///< `vertex` equals the vertex `other`
    collinear,         ///< all vertices on one line: no area
    not_coplanar,      ///< `vertex` is `deviation` away from the polygon's plane, more than 1e-9 of the diameter
    not_convex,        ///< the boundary turns the other way at `vertex`
    self_crossing,     ///< turns one way everywhere, but more than once around (star order), or runs back on itself
  };
  Kind kind;
  std::uint32_t vertex = 0;
  std::uint32_t other = 0;
  double deviation = 0;  ///< length unit of the points; relative error below 1e-12
};

/// A convex polygon in space, counterclockwise seen from its front.
///
/// Definition: at least 3 vertices, none repeated, not all collinear; collinear vertices are allowed and kept.
/// Vertices are exactly coplanar, or deviate from a plane by at most 1e-9 of the diameter ("rounded", see is_flat).
class ConvexPolygon {
 public:
  /// Requires: `defect(points)` is empty.
  /// Throws:   PreconditionError otherwise.
  static ConvexPolygon from_points(std::vector<Point3> points);

  /// The first reason why the points are no convex polygon, or nothing.
  ///
  /// Exactness: decided by exact signs; the deviation is compared in exact arithmetic.
  static std::optional<PolygonDefect> defect(std::span<const Point3> points);

  /// The vertices in the order given.
  std::span<const Point3> points() const { return points_; }

  /// Indices of the vertices at which the boundary turns, in order: collinear vertices are left out.
  std::span<const std::uint32_t> corners() const { return corners_; }

  /// Lowest index of the edges that make up the side from corner k to corner k + 1.
  std::uint32_t side_edge(std::uint32_t k) const { return side_edge_[k]; }

  /// Lowest index of the vertices on the closed side from corner k to corner k + 1.
  std::uint32_t side_lowest_vertex(std::uint32_t k) const { return side_lowest_vertex_[k]; }

  /// True if the vertices are exactly coplanar.
  bool is_flat() const { return deviation_ == 0; }

  /// Largest distance of a vertex from the polygon's plane; 0 if and only if the polygon is flat.
  double deviation() const { return deviation_; }

 private:
  ConvexPolygon() = default;

  std::vector<Point3> points_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> side_edge_;
  std::vector<std::uint32_t> side_lowest_vertex_;
  double deviation_ = 0;
};

}  // namespace gnomon
