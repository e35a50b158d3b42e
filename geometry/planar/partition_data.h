#pragma once

#include "geometry/planar/exact_polygon.h"
#include "geometry/planar/partition.h"

namespace gnomon::planar {

/// What a partition holds.
struct Partition::Data {
  Sight sight;
  std::optional<Box2> box;
  std::vector<BoundaryName> names;
  std::vector<ExactPoint> exact_vertices;
  std::vector<Point2> vertices;
  std::vector<PartitionEdge> edges;
  std::vector<PartitionFace> faces;
};

}  // namespace gnomon::planar
