#include "geometry/bodies/box_hierarchy.h"

#include <algorithm>
#include <numeric>

#include "geometry/bodies/boxes.h"

namespace gnomon {
namespace {

constexpr std::uint32_t leaf_size = 2;

}  // namespace

BoxHierarchy::BoxHierarchy(const std::vector<Box3>& boxes) : order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (boxes.empty()) return;
  branches_.emplace_back();
  build(boxes, 0, 0, static_cast<std::uint32_t>(boxes.size()));
  boxes_.reserve(boxes.size());
  for (const std::uint32_t n : order_) boxes_.push_back(boxes[n]);
}

void BoxHierarchy::build(const std::vector<Box3>& boxes, std::uint32_t branch, std::uint32_t first,
                         std::uint32_t last) {
  Box3 box = empty_box3();
  for (std::uint32_t i = first; i < last; ++i) {
    include(box, boxes[order_[i]].min);
    include(box, boxes[order_[i]].max);
  }
  branches_[branch] = {box, first, last - first};
  if (last - first <= leaf_size) return;
  const double dx = box.max.x - box.min.x, dy = box.max.y - box.min.y, dz = box.max.z - box.min.z;
  const auto middle = [&](std::uint32_t i) {
    const Box3& b = boxes[i];
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
  build(boxes, child, first, half);
  build(boxes, child + 1, half, last);
}

}  // namespace gnomon
