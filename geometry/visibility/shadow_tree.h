#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "geometry/numbers/exact_vector.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"
#include "gnomon/names.h"

namespace gnomon {

/// Convex pieces of a polygon, each its corners in the polygon's order.
struct ShadowPieces {
  std::vector<ExactPolygon> lit;
  std::vector<ExactPolygon> shadow;
};

/// The shadows of all blockers under a light without size, as a binary tree of planes.
///
/// Definition: each node is a plane through the light and an edge of a blocker, so cells are cones with their tip in
/// the
///             light, prisms under a directional one. A cell's leaf lists polygons that hide all of it: facets that
///             face the light. Behind the plane of one of them there is shadow, before all there is light. Of two of
///             which one is nowhere before the other only the nearer is kept.
/// Exactness:  points are judged by signs of determinants of input points alone, doubles first. Pieces have exact
///             corners.
/// Cost:       built front to back, by cutting facets exactly; a question costs the path to a leaf and its list.
/// After:      [ChinF89]; [CF91] §4.2.4, where the leaves' planes are left out.
class ShadowTree {
 public:
  using SmallLight = std::variant<PointLight, DirectionalLight>;

  ShadowTree(const SmallLight& light, std::span<const ConvexBlocker> blockers);
  ShadowTree(ShadowTree&&) noexcept;
  ShadowTree& operator=(ShadowTree&&) noexcept;
  ~ShadowTree();

  /// Lit or umbra; nothing for a point on one of the planes on its path, where shadows may only graze it, and where the
  /// light touches a solid or a coordinate exceeds 1e30.
  ///
  /// Requires: finite coordinates.
  std::optional<Region> region_from(const Point3& point) const;

  /// A flat polygon in pieces that are lit and in shadow, but for their boundaries.
  /// Requires: a polygon not seen edge-on by the light; the light touches no solid (else everything is told as lit);
  ///           coordinates of at most 1e30.
  ShadowPieces pieces(std::span<const Point3> polygon) const;

  std::size_t node_count() const;  ///< inner nodes and leaves
  std::size_t height() const;      ///< the longest path's nodes
  /// How many planes the point was held against.
  std::size_t tests(const Point3& point) const;

  class Content;

 private:
  std::unique_ptr<const Content> content_;
};

}  // namespace gnomon
