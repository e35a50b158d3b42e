#include "geometry/visibility/linear_search/voxel_grid.h"

#include <algorithm>
#include <cmath>

#include "geometry/bodies/boxes.h"
#include "geometry/visibility/linear_search/triangle_in_box.h"

namespace gnomon::viewpoint {
namespace {

/// Exceeds, for a number of this size, what adding steps to the lower end may round.
double margin(double low, double high) {
  return 0x1p-44 * (std::fabs(low) + std::fabs(high)) + tiny;
}

}  // namespace

/// Which voxel holds x, or the nearest. It grows with x, whatever is rounded.
std::uint32_t VoxelGrid::voxel_of(double x, double low, double step) const {
  const double place = (x - low) / step;
  return place > 0 ? static_cast<std::uint32_t>(std::min<double>(place, side_ - 1)) : 0;
}

std::array<VoxelGrid::Range, 3> VoxelGrid::ranges(const Box3& box) const {
  return {Range{voxel_of(box.min.x, whole_.min.x, step_.x), voxel_of(box.max.x, whole_.min.x, step_.x)},
          Range{voxel_of(box.min.y, whole_.min.y, step_.y), voxel_of(box.max.y, whole_.min.y, step_.y)},
          Range{voxel_of(box.min.z, whole_.min.z, step_.z), voxel_of(box.max.z, whole_.min.z, step_.z)}};
}

/// A box that holds every point of the voxels, whatever was rounded.
Box3 VoxelGrid::voxels(const std::array<Range, 3>& range) const {
  const auto low = [](double from, double to, double step, std::uint32_t i) {
    return from + i * step - margin(from, to);
  };
  const auto high = [](double from, double to, double step, std::uint32_t i) {
    return from + (i + 1) * step + margin(from, to);
  };
  const auto& [x, y, z] = range;
  return {{low(whole_.min.x, whole_.max.x, step_.x, x.first), low(whole_.min.y, whole_.max.y, step_.y, y.first),
           low(whole_.min.z, whole_.max.z, step_.z, z.first)},
          {high(whole_.min.x, whole_.max.x, step_.x, x.last), high(whole_.min.y, whole_.max.y, step_.y, y.last),
           high(whole_.min.z, whole_.max.z, step_.z, z.last)}};
}

/// Of a solid the voxels that its box meets, of a flat blocker those of them that it may meet itself.
template <class Visit>
void VoxelGrid::for_each_voxel(const BlockerSet::Content& blockers, std::uint32_t blocker, const Visit& visit) const {
  const BlockerSet::Content::Shape& shape = blockers.shapes[blocker];
  const std::span<const Point3> points = blockers.points_of(shape);
  const auto [x, y, z] = ranges(box_around(points));
  for (std::uint32_t i = x.first; i <= x.last; ++i) {
    for (std::uint32_t j = y.first; j <= y.last; ++j) {
      for (std::uint32_t k = z.first; k <= z.last; ++k) {
        if (shape.solid < 0 && !may_meet(points, voxels({Range{i, i}, Range{j, j}, Range{k, k}}))) continue;
        visit((i * side_ + j) * side_ + k);
      }
    }
  }
}

/// Counts what each voxel is to hold, turns the counts into places, and fills these from their ends.
VoxelGrid::VoxelGrid(BlockerSet set, std::uint32_t side) : side_(side), whole_(empty_box3()) {
  const BlockerSet::Content& blockers = set.content();
  for (const BlockerSet::Content::Shape& shape : blockers.shapes) {
    for (const Point3& p : blockers.points_of(shape)) include(whole_, p);
  }
  const auto step = [&](double low, double high) { return high > low ? (high - low) / side : 1; };
  step_ = {step(whole_.min.x, whole_.max.x), step(whole_.min.y, whole_.max.y), step(whole_.min.z, whole_.max.z)};
  const auto count = static_cast<std::uint32_t>(blockers.shapes.size());
  ends_.assign(std::size_t(side) * side * side + 1, 0);
  for (std::uint32_t b = 0; b < count; ++b) {
    for_each_voxel(blockers, b, [&](std::uint32_t voxel) { ++ends_[voxel + 1]; });
  }
  for (std::size_t voxel = 1; voxel < ends_.size(); ++voxel) ends_[voxel] += ends_[voxel - 1];
  members_.resize(ends_.back());
  for (std::uint32_t b = 0; b < count; ++b) {
    for_each_voxel(blockers, b, [&](std::uint32_t voxel) { members_[ends_[voxel]++] = b; });
  }
}

void VoxelGrid::find_candidates(const LightTriangle& triangle, std::vector<std::uint32_t>& found,
                                SearchCounts& counts) const {
  found.clear();
  const Box3 around = box_around(triangle.corners);
  if (members_.empty() || !overlap(around, whole_)) return;
  const auto [x, y, z] = ranges(around);
  const auto meets = [&](const std::array<Range, 3>& range) {
    ++counts.tested;
    return may_meet(triangle.corners, voxels(range));
  };
  for (std::uint32_t i = x.first; i <= x.last; ++i) {
    for (std::uint32_t j = y.first; j <= y.last; ++j) {
      if (!meets({Range{i, i}, Range{j, j}, z})) continue;
      for (std::uint32_t k = z.first; k <= z.last; ++k) {
        if (!meets({Range{i, i}, Range{j, j}, Range{k, k}})) continue;
        ++counts.visited;
        const std::uint32_t voxel = (i * side_ + j) * side_ + k;
        const std::size_t first = voxel == 0 ? 0 : ends_[voxel - 1];
        if (ends_[voxel] == first) continue;
        counts.gathered += ends_[voxel] - first;
        found.insert(found.end(), &members_[first], &members_[first] + (ends_[voxel] - first));
      }
    }
  }
}

}  // namespace gnomon::viewpoint
