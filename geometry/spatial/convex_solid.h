#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.h"

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

}  // namespace gnomon
