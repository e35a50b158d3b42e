#include "geometry/visibility/silhouette_grid.h"

#include <algorithm>
#include <cmath>

namespace gnomon::viewpoint {
namespace {

/// With fewer silhouettes looking at each is faster.
constexpr std::size_t smallest_grid = 256;

/// Which of `side` equal cells between low and high holds x, or the nearest. It grows with x, whatever is rounded, so
/// boxes that meet have a cell in common.
std::uint32_t cell_of(double x, double low, double high, std::uint32_t side) {
  const double place = (x - low) / (high - low) * side;
  return place > 0 ? static_cast<std::uint32_t>(std::min<double>(place, side - 1)) : 0;
}

/// The number of columns and of rows with which the boxes meet at most four cells each on the average:
/// (1 + k w)(1 + k h), with w and h the parts of the whole box that they are wide and high.
std::uint32_t side_for(std::span<const Silhouette> silhouettes) {
  const FlatBox& whole = silhouettes.front().box;
  const double width = whole.high_u - whole.low_u, height = whole.high_v - whole.low_v;
  const auto count = static_cast<double>(silhouettes.size() - 1);
  double sides = 0, area = 0;
  for (const Silhouette& silhouette : silhouettes.subspan(1)) {
    const double w = std::max(0.0, (silhouette.box.high_u - silhouette.box.low_u) / width);
    const double h = std::max(0.0, (silhouette.box.high_v - silhouette.box.low_v) / height);
    sides += w + h;
    area += w * h;
  }
  const double side = std::min({std::sqrt(count), count / sides, std::sqrt(count / area)});
  return side >= 1 ? static_cast<std::uint32_t>(side) : 1;
}

}  // namespace

SilhouetteGrid::Range SilhouetteGrid::columns(const FlatBox& box) const {
  const FlatBox& whole = silhouettes_.front().box;
  return {cell_of(box.low_u, whole.low_u, whole.high_u, side_), cell_of(box.high_u, whole.low_u, whole.high_u, side_)};
}

SilhouetteGrid::Range SilhouetteGrid::rows(const FlatBox& box) const {
  const FlatBox& whole = silhouettes_.front().box;
  return {cell_of(box.low_v, whole.low_v, whole.high_v, side_), cell_of(box.high_v, whole.low_v, whole.high_v, side_)};
}

template <class Visit>
void SilhouetteGrid::for_each_cell(const FlatBox& box, const Visit& visit) const {
  const Range across = columns(box), along = rows(box);
  for (std::uint32_t row = along.first; row <= along.last; ++row) {
    for (std::uint32_t column = across.first; column <= across.last; ++column) visit(row * side_ + column);
  }
}

/// Counts what each cell is to hold, turns the counts into places, and fills these from their ends.
void SilhouetteGrid::build(std::span<const Silhouette> silhouettes) {
  silhouettes_ = silhouettes;
  side_ = silhouettes.size() < smallest_grid ? 1 : side_for(silhouettes);
  if (side_ == 1) return;
  const auto count = static_cast<std::uint32_t>(silhouettes.size());
  ends_.assign(side_ * side_ + 1, 0);
  for (std::uint32_t i = 1; i < count; ++i) {
    for_each_cell(silhouettes[i].box, [&](std::uint32_t cell) { ++ends_[cell + 1]; });
  }
  for (std::size_t cell = 1; cell < ends_.size(); ++cell) ends_[cell] += ends_[cell - 1];
  members_.resize(ends_.back());
  for (std::uint32_t i = 1; i < count; ++i) {
    for_each_cell(silhouettes[i].box, [&](std::uint32_t cell) { members_[ends_[cell]++] = i; });
  }
  last_seen_.assign(count, 0);
  search_ = 0;
}

void SilhouetteGrid::find(const FlatBox& box, std::vector<std::uint32_t>& found) {
  found.clear();
  if (side_ == 1) {
    for (std::uint32_t i = 1; i < silhouettes_.size(); ++i) {
      if (box.meets(silhouettes_[i].box)) found.push_back(i);
    }
    return;
  }
  ++search_;
  for_each_cell(box, [&](std::uint32_t cell) {
    for (std::uint32_t m = cell == 0 ? 0 : ends_[cell - 1]; m < ends_[cell]; ++m) {
      const std::uint32_t i = members_[m];
      if (last_seen_[i] == search_ || !box.meets(silhouettes_[i].box)) continue;
      last_seen_[i] = search_;
      found.push_back(i);
    }
  });
  std::sort(found.begin(), found.end());
}

}  // namespace gnomon::viewpoint
