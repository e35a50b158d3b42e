#pragma once

/// Which facets of closed meshes an area light never meets from their front. Private to this folder.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/visibility/blocker_content.h"

namespace gnomon::viewpoint {

/// The flat blockers that belong to a closed surface and have no corner of the light before them, each with the box
/// around its surface. Points outside of that box need not look at them.
///
/// Definition: a closed surface is a set of flat blockers each of whose edges is an edge of exactly one other one,
///             which has it the other way round. Before a facet is where its corners run counterclockwise.
/// Exactness:  let the box around the surface hold neither the point nor a point of the light. Then the surface winds
///             around neither, and along a line of sight that meets no edge of it, passages through facets with the
///             light before them are as many as with the light behind. So whatever a facet with the light behind it
///             hides, one with the light before it hides too, but for lines of sight through edges or in facets'
///             planes, which are of no area of the light. It does not matter whether the surface passes through itself
///             or is inside out.
class TurnedAway {
 public:
  TurnedAway(const BlockerSet::Content& blockers, std::span<const Point3> light);

  /// Removes of the blockers found those that need not be looked at from the point.
  void remove_from(std::vector<std::uint32_t>& found, const Point3& point) const;

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  std::vector<std::uint32_t> box_of_;  ///< of each blocker that is turned away, its surface's box; else none
  std::vector<Box3> boxes_;
};

}  // namespace gnomon::viewpoint
