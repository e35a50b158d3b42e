#pragma once

/// @file
/// What stands in the light: flat polygons, solids, closed surfaces.
///
///     #include <gnomon/blocker.h>
///     int main() {
///       using namespace gnomon;
///       const ConvexBlocker board = ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
///       const ConvexBlocker solid = ConvexSolid::hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
///       return board.index() == 0 && std::get<ConvexSolid>(solid).facets().size() == 4 ? 0 : 1;
///     }

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "gnomon/convex_polygon.h"
#include "gnomon/point.h"

namespace gnomon {

/// The convex hull of points that has an interior: a convex polytope.
///
/// Degenerate: repeated points, points inside the hull and points inside its facets and edges are kept in points(), but
///             are no corners.
/// Exactness:  decided by signs of orientation determinants of input points.
class ConvexSolid {
 public:
  /// A facet.
  /// Orientation: the loop runs counterclockwise seen from outside. It is strictly convex: coplanar pieces are one
  ///              facet, and points on its edges are left out. It starts at its lowest index.
  struct Facet {
    std::vector<std::uint32_t> loop;

    friend bool operator==(const Facet&, const Facet&) = default;
  };

  /// An edge: the facet `left` holds it from -> to, the facet `right` to -> from. `from` is below `to`.
  struct Edge {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t left;
    std::uint32_t right;

    friend bool operator==(const Edge&, const Edge&) = default;
  };

  /// The hull of the points.
  ///
  /// Requires: finite points, at least 4, not all in one plane.
  /// Cost:     O(n log n) predicates on average.
  /// Throws:   PreconditionError.
  static ConvexSolid hull_of(std::vector<Point3> points);

  /// The points as given; indices count these.
  std::span<const Point3> points() const { return points_; }

  /// Indices of the hull's vertices, ascending. Of equal points the first stands for all.
  std::span<const std::uint32_t> corners() const { return corners_; }

  /// The facets, ordered by their loops.
  std::span<const Facet> facets() const { return facets_; }

  /// The edges, ordered by their ends.
  std::span<const Edge> edges() const { return edges_; }

 private:
  ConvexSolid() = default;

  std::vector<Point3> points_;
  std::vector<std::uint32_t> corners_;
  std::vector<Facet> facets_;
  std::vector<Edge> edges_;
};

/// An opaque convex set of space: a flat polygon, which hides from both sides, or a solid.
/// A polygon in here is exactly flat.
using ConvexBlocker = std::variant<ConvexPolygon, ConvexSolid>;

/// The set that a polygon stands for: itself if it is flat, else the solid between its rounded vertices.
ConvexBlocker convex_blocker(const ConvexPolygon& polygon);

/// A surface without boundary, made of triangles: every edge runs as often one way as the other.
struct ClosedSurface {
  std::vector<Point3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices
};

}  // namespace gnomon
