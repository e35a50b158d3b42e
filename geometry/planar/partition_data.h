#pragma once

#include <array>
#include <vector>

#include "geometry/planar/exact_polygon.h"
#include "gnomon/flatland_partition.h"

namespace gnomon::planar {

/// What a partition holds.
struct Partition::Data {
  LightVisibility visibility;
  std::optional<Box2> box;
  std::vector<BoundaryName> names;
  std::vector<ExactPoint> exact_vertices;
  std::vector<Point2> vertices;
  std::vector<PartitionEdge> edges;
  /// Two points of each edge's closure in its order: its ends, and for one at infinity a point far out.
  std::vector<std::array<ExactPoint, 2>> edge_points;
  std::vector<PartitionFace> faces;
};

}  // namespace gnomon::planar
