#pragma once

/// Private to geometry/visibility.

#include "geometry/bodies/box_hierarchy.h"
#include "geometry/visibility/linear_search/light_cylinder.h"
#include "geometry/visibility/linear_search/light_triangle.h"

namespace gnomon::viewpoint {

/// A hierarchy of boxes in cylindrical coordinates about the light.
///
/// The triangle has one turn, distances up to the point's, and a span along the light that narrows linearly, so a box
/// is held against it by three comparisons. A blocker across the seam, half a turn from where turns are 0, is stored on
/// both sides of it; one that the light's line may pierce goes all round.
class LightHierarchy {
 public:
  LightHierarchy(const LinearLight& light, BlockerSet blockers);

  /// Cost: as of any search in a hierarchy. Near the light's line, where there is no turn, that of BlockerSet.
  void find_candidates(const LightTriangle& triangle, std::vector<std::uint32_t>& found, SearchCounts& counts) const;

  std::size_t references() const { return owners_.size(); }

 private:
  void add(const CylinderBox& box, double turned, std::uint32_t owner, std::vector<Box3>& boxes);

  BlockerSet blockers_;
  LightCylinder cylinder_;
  double turn_scale_ = 1;              ///< makes turns about as long as ways round at the blockers' distance
  std::vector<std::uint32_t> owners_;  ///< blockers of the boxes
  BoxHierarchy boxes_;                 ///< x: scaled turn, y: distance, z: along
};

}  // namespace gnomon::viewpoint
