#pragma once

#include <cstdint>
#include <memory>

#include "geometry/planar/partition.h"
#include "geometry/planar/sight.h"
#include "geometry/point.h"
#include "geometry/region.h"

namespace gnomon::planar {

/// A partition prepared for questions about many points.
///
/// Definition: the plane is cut into slabs by the upright lines through the vertices; the edges that cross a slab have
///             one order in all of it.
/// Degenerate: a point on an edge or a vertex lies in no face, and what holds there is asked of the point itself.
/// Exactness:  all answers are those of Sight for every finite point.
/// Cost:       to prepare O(v (log v + e)) for v vertices and at most e edges across a slab, in time and in memory. A
///             point in a face O(log v); one on an edge or a vertex, or outside the box, what it costs Sight.
class PartitionLocation {
 public:
  explicit PartitionLocation(const Partition& partition);

  /// Where the point lies: index into Partition::faces, or `nowhere` on an edge or a vertex and outside the box.
  std::uint32_t face(const Point2& point) const;

  /// The region of the point.
  Region region(const Point2& point) const;

  /// What the point sees of the light. In a penumbra face of a partition without the structure, what it costs Sight.
  ///
  /// Degenerate: where two ends hide one another as seen from the point, an interval may bear the name of either.
  VisibleLight visible_light(const Point2& point) const;

 private:
  class Slabs;

  Partition partition_;
  std::shared_ptr<const Slabs> slabs_;
};

}  // namespace gnomon::planar
