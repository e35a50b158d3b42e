#pragma once

/// Private to geometry/visibility.

#include "geometry/visibility/linear_search/light_triangle.h"

namespace gnomon::viewpoint {

/// Holds every blocker against the triangle's plane, and keeps those that it may cut.
/// After: [P93] §4.3.1, where each primitive is asked.
class PlaneSearch {
 public:
  explicit PlaneSearch(BlockerSet blockers) : blockers_(std::move(blockers)) {}

  /// Cost: every corner of every blocker.
  void find_candidates(const LightTriangle& triangle, std::vector<std::uint32_t>& found, SearchCounts& counts) const;

  std::size_t references() const { return blockers_.size(); }

 private:
  BlockerSet blockers_;
};

}  // namespace gnomon::viewpoint
