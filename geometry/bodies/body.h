#pragma once

#include <cstdint>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon {

/// A light or a blocker as the algorithms of a pair see it: corners, edges and facets of its convex body. One or two
/// points have no facets; a flat polygon has two, its front and its back; the rest are polytopes.
struct Body {
  static constexpr std::uint32_t none = ~0u;

  /// An edge. Orientation: the facet `left` runs from -> to, the facet `right` to -> from, seen from outside. The
  /// single edge of a segment has no facets.
  struct Edge {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t left;
    std::uint32_t right;
    std::uint32_t name;  ///< its index in the file's order (of a solid: in ConvexSolid::edges), or none for a diagonal
    std::uint32_t first_inside = 0;  ///< `inside` vertices of a flat polygon strictly between its ends: those from
    std::uint32_t last_inside = 0;   ///< the first to before the last
  };
  /// A vertex of a polygon that is no corner.
  struct InsideVertex {
    std::uint32_t index;
    Point3 point;
  };
  /// A facet. Orientation: its corners run counterclockwise seen from outside.
  struct Facet {
    std::vector<std::uint32_t> loop;
  };

  std::vector<Point3> corners;
  std::vector<std::uint32_t> index;  ///< of each corner, in the file's order
  std::vector<Edge> edges;
  std::vector<Facet> facets;
  std::vector<InsideVertex> inside;
  bool flat = false;         ///< a polygon with front and back
  bool at_infinity = false;  ///< the one corner is the direction that leads to a directional light

  const Point3& facet_point(std::uint32_t facet, std::uint32_t k) const { return corners[facets[facet].loop[k]]; }
};

/// The vertices of a light; none for a directional light.
std::vector<Point3> light_points(const Light& light);

Body body(const Light& light);
Body body(const ConvexBlocker& blocker);

}  // namespace gnomon
