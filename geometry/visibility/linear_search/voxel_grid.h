#pragma once

/// Private to geometry/visibility.

#include "geometry/visibility/linear_search/light_triangle.h"

namespace gnomon::viewpoint {

/// The box around all blockers in n x n x n voxels, each with a list of the blockers that may meet it; the triangle is
/// scan-converted, column by column.
///
/// Cost:  memory for n cubed voxels and for a blocker in each that it may meet.
/// After: [P93] §4.3.2.
class VoxelGrid {
 public:
  VoxelGrid(BlockerSet blockers, std::uint32_t side);

  void find_candidates(const LightTriangle& triangle, std::vector<std::uint32_t>& found, SearchCounts& counts) const;

  std::size_t references() const { return members_.size(); }

 private:
  /// Voxels from `first` to `last` in one direction.
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };
  std::uint32_t voxel_of(double x, double low, double step) const;
  std::array<Range, 3> ranges(const Box3& box) const;
  Box3 voxels(const std::array<Range, 3>& range) const;
  template <class Visit>
  void for_each_voxel(const BlockerSet::Content& blockers, std::uint32_t blocker, const Visit& visit) const;

  std::uint32_t side_;
  Box3 whole_;
  Point3 step_;                         ///< sides of a voxel
  std::vector<std::size_t> ends_;       ///< of each voxel, where its blockers end in `members_`
  std::vector<std::uint32_t> members_;  ///< blockers, voxel by voxel
};

}  // namespace gnomon::viewpoint
