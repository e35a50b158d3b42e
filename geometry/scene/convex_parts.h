#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/scene/scene.h"
#include "geometry/spatial/closed_surface.h"
#include "geometry/spatial/convex_blocker.h"

namespace gnomon {

/// What parts are made for. A convex mesh with dents, as rounding makes them, is the hull of its vertices for volumes;
/// for points it is what it is, so that points on its facets do not come to lie inside of it.
enum class PartsFor { points, volumes };

/// A convex piece of a blocker.
struct ConvexPart {
  std::string name;
  ConvexBlocker shape;
  std::vector<std::uint32_t> vertices;  ///< of each point of `shape`, its index among the blocker's vertices
};

/// The convex pieces whose union is the blocker.
///
/// Definition: a polygon is itself, or, rounded, the solid between its vertices; a polytope is its hull. A concave
///             polygon `board`, one with holes or a bent one is cut along diagonals between its own vertices into
///             `board#0`, `board#1`, ...: see convex_partition. Facet 12 of a mesh `vase` is `vase#12`, and if it is no
///             convex polygon `vase#12#0`, `vase#12#1`, ... Rounded pieces are solids. A convex closed mesh is one
///             solid, `vase`, one with dents for volumes only. Another closed mesh consists of its facets here; what it
///             encloses, enclosed_space tells.
/// Returns:    at least one part; in the order of the names.
/// Requires:   a blocker as scene files hold it: see BlockerShape.
/// Exactness:  no vertex is constructed; convexity is decided by exact signs.
/// Cost:       O(n log n) for most, O(n²) for the worst concave polygons.
std::vector<ConvexPart> convex_parts(const SceneBlocker& blocker, PartsFor use = PartsFor::points);

/// The vertices of the pieces alone: of a polygon, and of a facet of a mesh, which is its own piece where it is convex.
std::vector<std::vector<std::uint32_t>> convex_pieces(const ConcavePolygon& polygon);
std::vector<std::vector<std::uint32_t>> convex_pieces(std::span<const Point3> points,
                                                      const std::vector<std::uint32_t>& facet);

/// The surface that a closed mesh is which is no solid, in triangles between its own vertices; nothing for other
/// blockers.
std::optional<ClosedSurface> enclosed_space(const SceneBlocker& blocker);

}  // namespace gnomon
