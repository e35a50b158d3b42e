#pragma once

/// What a BlockerSet consists of. Private to this folder.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bodies/box_hierarchy.h"
#include "geometry/visibility/blocker_set.h"
#include "geometry/visibility/silhouette.h"
#include "gnomon/blocker.h"

namespace gnomon {

/// The pyramid with its apex in the eye and its base on the light's plane.
struct LightPyramid {
  Point3 apex;
  std::span<const viewpoint::Plane> sides;  ///< positive side inside
  const viewpoint::LightPlane& base;
};

/// The segment between two points, or the ray from the first in a direction.
struct LineBetween {
  Point3 from;
  Point3 to;  ///< its end, or the ray's direction
  bool ends = true;
};

struct BlockerSet::Content {
  /// A blocker. A flat one has its corners in `points` and the names of their edges in `names`.
  struct Shape {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::int32_t solid = -1;  ///< index in `solids`, or -1 for a flat blocker
  };
  /// The one other edge of a flat blocker between the same two points.
  struct Mate {
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    std::uint32_t shape = none;
    bool is_opposite = false;  ///< it runs the other way
  };
  std::vector<Point3> points;
  std::vector<std::uint32_t> names;
  std::vector<Mate> mates;  ///< of the edges that start at the points; none where several blockers have an edge
  std::vector<Shape> shapes;
  std::vector<ConvexSolid> solids;
  BoxHierarchy boxes;           ///< of the shapes; empty where these are few
  std::vector<Box3> few_boxes;  ///< of the shapes where these are few
  double largest = 0;           ///< absolute coordinate

  std::span<const Point3> corners(const Shape& shape) const { return {points.data() + shape.first, shape.count}; }
  std::span<const Point3> points_of(const Shape& shape) const {
    return shape.solid >= 0 ? solids[static_cast<std::size_t>(shape.solid)].points() : corners(shape);
  }

  /// Replaces `found` by the indices, ascending, of every blocker that has a point in the pyramid, and some others.
  /// Returns:   the number of nodes of the hierarchy, or of blockers, that were looked at.
  /// Exactness: a box is left out only where its distance exceeds all that may have been rounded.
  std::size_t collect(const LightPyramid& pyramid, std::vector<std::uint32_t>& found) const;

  /// The same for a line of sight, in any order.
  void collect_along(const LineBetween& line, std::vector<std::uint32_t>& found) const;

  /// The same for a point: every blocker that it is within rounding of (resting_point), ascending, and some others.
  void collect_near(const Point3& p, std::vector<std::uint32_t>& found) const;

  /// Replaces `found` by all blockers but solids, which have many facets to look at, whose boxes do not meet: where
  /// they are few.
  template <class MayMeet>
  void collect_few(const MayMeet& may_meet, std::vector<std::uint32_t>& found) const {
    found.clear();
    for (std::uint32_t b = 0; b < shapes.size(); ++b) {
      if (shapes[b].solid < 0 || may_meet(few_boxes[b])) found.push_back(b);
    }
  }
};

}  // namespace gnomon
