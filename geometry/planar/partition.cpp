#include "gnomon/flatland_partition.h"

#include <algorithm>

#include "geometry/planar/partition_data.h"

namespace gnomon::planar {

const std::vector<Point2>& Partition::vertices() const {
  return data_->vertices;
}

const std::vector<PartitionEdge>& Partition::edges() const {
  return data_->edges;
}

const std::vector<PartitionFace>& Partition::faces() const {
  return data_->faces;
}

const std::vector<BoundaryName>& Partition::names() const {
  return data_->names;
}

const LightVisibility& Partition::visibility() const {
  return data_->visibility;
}

const std::optional<Box2>& Partition::box() const {
  return data_->box;
}

std::size_t Partition::count(Region region) const {
  return static_cast<std::size_t>(std::ranges::count(data_->faces, region, &PartitionFace::region));
}

}  // namespace gnomon::planar
