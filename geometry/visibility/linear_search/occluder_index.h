#pragma once

/// Private to geometry/visibility.

#include <variant>

#include "geometry/visibility/linear_search/hierarchy_search.h"
#include "geometry/visibility/linear_search/light_buffer.h"
#include "geometry/visibility/linear_search/light_hierarchy.h"
#include "geometry/visibility/linear_search/plane_search.h"
#include "geometry/visibility/linear_search/voxel_grid.h"
#include "gnomon/visibility.h"

namespace gnomon::viewpoint {

/// Blockers made ready for being searched for those that may hide one linear light. Any number of threads may read it.
class OccluderIndex {
 public:
  OccluderIndex(const LinearLight& light, BlockerSet blockers, const LinearSearch& search);

  /// Replaces `found` by the indices, ascending, of every blocker that has a point in the closed triangle, and some
  /// others.
  void find(const LightTriangle& triangle, std::vector<std::uint32_t>& found, SearchCounts& counts) const;

  std::size_t references() const;
  const BlockerSet& blockers() const { return blockers_; }

 private:
  using Search = std::variant<HierarchySearch, PlaneSearch, VoxelGrid, LightBuffer, LightHierarchy>;
  static Search search_of(const LinearLight& light, const BlockerSet& blockers, const LinearSearch& search);

  BlockerSet blockers_;
  Search search_;
};

}  // namespace gnomon::viewpoint
