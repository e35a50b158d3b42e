#include "geometry/visibility/outline_grid.h"

#include <algorithm>
#include <cmath>

namespace gnomon::sight {
namespace {

/// With fewer outlines looking at each is faster.
constexpr std::size_t smallest_grid = 256;

/// Which of `side` equal cells between low and high holds x, or the nearest. It grows with x, whatever is rounded, so
/// boxes that meet have a cell in common.
std::uint32_t cell_of(double x, double low, double high, std::uint32_t side) {
  const double place = (x - low) / (high - low) * side;
  return place > 0 ? static_cast<std::uint32_t>(std::min<double>(place, side - 1)) : 0;
}

/// The number of columns and of rows with which the boxes meet at most four cells each on the average:
/// (1 + k w)(1 + k h), with w and h the parts of the whole box that they are wide and high.
std::uint32_t side_for(std::span<const Outline> outlines) {
  const FlatBox& whole = outlines.front().box;
  const double width = whole.high_u - whole.low_u, height = whole.high_v - whole.low_v;
  const auto count = static_cast<double>(outlines.size() - 1);
  double sides = 0, area = 0;
  for (const Outline& outline : outlines.subspan(1)) {
    const double w = std::max(0.0, (outline.box.high_u - outline.box.low_u) / width);
    const double h = std::max(0.0, (outline.box.high_v - outline.box.low_v) / height);
    sides += w + h;
    area += w * h;
  }
  const double side = std::min({std::sqrt(count), count / sides, std::sqrt(count / area)});
  return side >= 1 ? static_cast<std::uint32_t>(side) : 1;
}

}  // namespace

OutlineGrid::Range OutlineGrid::columns(const FlatBox& box) const {
  const FlatBox& whole = outlines_.front().box;
  return {cell_of(box.low_u, whole.low_u, whole.high_u, side_), cell_of(box.high_u, whole.low_u, whole.high_u, side_)};
}

OutlineGrid::Range OutlineGrid::rows(const FlatBox& box) const {
  const FlatBox& whole = outlines_.front().box;
  return {cell_of(box.low_v, whole.low_v, whole.high_v, side_), cell_of(box.high_v, whole.low_v, whole.high_v, side_)};
}

template <class Visit>
void OutlineGrid::for_each_cell(const FlatBox& box, const Visit& visit) const {
  const Range across = columns(box), along = rows(box);
  for (std::uint32_t row = along.first; row <= along.last; ++row) {
    for (std::uint32_t column = across.first; column <= across.last; ++column) visit(row * side_ + column);
  }
}

/// Counts what each cell is to hold, turns the counts into places, and fills these from their ends.
void OutlineGrid::build(std::span<const Outline> outlines) {
  outlines_ = outlines;
  side_ = outlines.size() < smallest_grid ? 1 : side_for(outlines);
  if (side_ == 1) return;
  const auto count = static_cast<std::uint32_t>(outlines.size());
  ends_.assign(side_ * side_ + 1, 0);
  for (std::uint32_t i = 1; i < count; ++i) {
    for_each_cell(outlines[i].box, [&](std::uint32_t cell) { ++ends_[cell + 1]; });
  }
  for (std::size_t cell = 1; cell < ends_.size(); ++cell) ends_[cell] += ends_[cell - 1];
  members_.resize(ends_.back());
  for (std::uint32_t i = 1; i < count; ++i) {
    for_each_cell(outlines[i].box, [&](std::uint32_t cell) { members_[ends_[cell]++] = i; });
  }
  last_seen_.assign(count, 0);
  search_ = 0;
}

void OutlineGrid::find(const FlatBox& box, std::vector<std::uint32_t>& found) {
  found.clear();
  if (side_ == 1) {
    for (std::uint32_t i = 1; i < outlines_.size(); ++i) {
      if (box.meets(outlines_[i].box)) found.push_back(i);
    }
    return;
  }
  ++search_;
  for_each_cell(box, [&](std::uint32_t cell) {
    for (std::uint32_t m = cell == 0 ? 0 : ends_[cell - 1]; m < ends_[cell]; ++m) {
      const std::uint32_t i = members_[m];
      if (last_seen_[i] == search_ || !box.meets(outlines_[i].box)) continue;
      last_seen_[i] = search_;
      found.push_back(i);
    }
  });
  std::sort(found.begin(), found.end());
}

}  // namespace gnomon::sight
