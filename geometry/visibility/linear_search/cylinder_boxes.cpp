#include "geometry/visibility/linear_search/cylinder_boxes.h"

#include "geometry/visibility/blocker_content.h"

namespace gnomon::viewpoint {

std::vector<CylinderBox> cylinder_boxes(const LightCylinder& cylinder, const BlockerSet::Content& blockers) {
  std::vector<CylinderBox> boxes;
  boxes.reserve(blockers.shapes.size());
  std::vector<PointPair> edges;
  for (const BlockerSet::Content::Shape& shape : blockers.shapes) {
    edges.clear();
    if (shape.solid >= 0) {
      const ConvexSolid& solid = blockers.solids[static_cast<std::size_t>(shape.solid)];
      for (const ConvexSolid::Edge& edge : solid.edges()) edges.push_back({edge.from, edge.to});
      boxes.push_back(cylinder.box_of(solid.points(), edges));
    } else {
      for (std::uint32_t k = 0; k < shape.count; ++k) edges.push_back({k, k + 1 == shape.count ? 0 : k + 1});
      boxes.push_back(cylinder.box_of(blockers.corners(shape), edges));
    }
  }
  return boxes;
}

}  // namespace gnomon::viewpoint
