#include "geometry/bodies/box_hierarchy.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/bodies/boxes.h"

namespace gnomon {
namespace {

constexpr std::uint32_t leaf_size = 2;

}  // namespace

BoxHierarchy::BoxHierarchy(std::vector<Box3> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (boxes_.empty()) return;
  branches_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(boxes_.size()));
}

void BoxHierarchy::build(std::uint32_t branch, std::uint32_t first, std::uint32_t last) {
  Box3 box = empty_box3();
  for (std::uint32_t i = first; i < last; ++i) {
    include(box, boxes_[order_[i]].min);
    include(box, boxes_[order_[i]].max);
  }
  branches_[branch] = {box, first, last - first};
  if (last - first <= leaf_size) return;
  const double dx = box.max.x - box.min.x, dy = box.max.y - box.min.y, dz = box.max.z - box.min.z;
  const auto middle = [&](std::uint32_t i) {
    const Box3& b = boxes_[i];
    if (dx >= dy && dx >= dz) return b.min.x + b.max.x;
    return dy >= dz ? b.min.y + b.max.y : b.min.z + b.max.z;
  };
  const std::uint32_t half = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                   [&](std::uint32_t i, std::uint32_t j) { return middle(i) < middle(j); });
  const auto child = static_cast<std::uint32_t>(branches_.size());
  branches_[branch].first = child;
  branches_[branch].count = 0;
  branches_.emplace_back();
  branches_.emplace_back();
  build(child, first, half);
  build(child + 1, half, last);
}

}  // namespace gnomon
