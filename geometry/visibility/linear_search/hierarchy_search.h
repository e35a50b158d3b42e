#pragma once

/// Private to geometry/visibility.

#include "geometry/visibility/linear_search/light_triangle.h"

namespace gnomon::viewpoint {

/// Searches the hierarchy of boxes that the blockers have anyhow.
class HierarchySearch {
 public:
  explicit HierarchySearch(BlockerSet blockers) : blockers_(std::move(blockers)) {}

  void find_candidates(const LightTriangle& triangle, std::vector<std::uint32_t>& found, SearchCounts& counts) const {
    counts.visited += blockers_.content().collect(triangle.pyramid, found);
  }

  std::size_t references() const { return blockers_.size(); }

 private:
  BlockerSet blockers_;
};

}  // namespace gnomon::viewpoint
