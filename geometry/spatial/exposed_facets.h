#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/spatial/touching_sheets.h"

namespace gnomon {

/// A facet of a convex polyhedron.
struct ExactFacet {
  std::array<Rational, 4> plane;  ///< a x + b y + c z + d <= 0 inside
  std::vector<ExactVector> loop;  ///< strictly convex, counterclockwise seen from outside
};

using ExactEdge = std::array<ExactVector, 2>;

/// What the facets of several convex polyhedra contribute to the boundary of the union of all.
class ExposedFacets {
 public:
  /// `along` is a direction in which most polyhedra are long, as shadows are along rays of light: searches are faster
  /// then. It need not be a unit vector; zero for none.
  explicit ExposedFacets(std::span<const std::vector<ExactFacet>> polyhedra, const Point3& along = {});
  ExposedFacets(ExposedFacets&&) noexcept;
  ExposedFacets& operator=(ExposedFacets&&) noexcept;
  ~ExposedFacets();

  /// The boundary of what is left of a facet without the other polyhedra. Of facets in one plane with the same outside,
  /// the first one keeps what is common; with opposite outsides both lose it.
  ///
  /// Orientation: seen from outside, what is left lies on the left of each edge.
  /// Exactness:   filtered exact signs; polyhedra are left out where doubles hold boxes around them apart for certain.
  /// Cost:        a search in a hierarchy of boxes, and what convex_difference costs for those that it finds.
  std::vector<ExactEdge> edges(std::size_t polyhedron, std::size_t facet) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Triangles of a region of a plane that is given by its boundary; they use every edge of it.
///
/// Requires: edges bound a region in the plane, and meet in common ends only; they are indices of `points`.
/// Returns:  triangles counterclockwise seen from the plane's outside.
std::vector<std::array<std::uint32_t, 3>> region_triangles(const std::array<Rational, 4>& plane,
                                                           const std::vector<ExactVector>& points,
                                                           const std::vector<std::array<std::uint32_t, 2>>& edges);

}  // namespace gnomon
