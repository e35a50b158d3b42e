#include "geometry/discontinuity/box_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gnomon::event {
namespace {

constexpr std::uint32_t leaf_size = 2;

/// Far more than the relative error of the few operations below, in any rounding mode.
constexpr double slack = 0x1p-46;

Box3 joined(const Box3& a, const Box3& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

/// True if no point of the box can be inside.
bool is_outside(const RoughHalfSpace& h, const Box3& box) {
  const double x = (h.normal[0] > 0 ? box.max.x : box.min.x) - h.origin.x;
  const double y = (h.normal[1] > 0 ? box.max.y : box.min.y) - h.origin.y;
  const double z = (h.normal[2] > 0 ? box.max.z : box.min.z) - h.origin.z;
  const double value = h.normal[0] * x + h.normal[1] * y + h.normal[2] * z;
  const double far = std::max(std::fabs(box.min.x - h.origin.x), std::fabs(box.max.x - h.origin.x)) +
                     std::max(std::fabs(box.min.y - h.origin.y), std::fabs(box.max.y - h.origin.y)) +
                     std::max(std::fabs(box.min.z - h.origin.z), std::fabs(box.max.z - h.origin.z));
  return value < -(h.error * far + h.offset);
}

}  // namespace

RoughHalfSpace rough_half_space(const Point3& origin, const RoughVector& u, const RoughVector& v) {
  const double size = sum_norm(u) * sum_norm(v);
  return {cross(u, v), origin, slack * size + 0x1p-1000, 0};
}

RoughHalfSpace rough_side(const RoughHalfSpace& plane, const RoughVector& along, const Point3& origin,
                          const Point3& inside) {
  RoughHalfSpace side{cross(plane.normal, along), origin, 0, 0};
  const double length = sum_norm(along);
  side.error = (plane.error + slack * sum_norm(plane.normal)) * length * 2 + 0x1p-1000;
  return turned_to(side, inside);
}

RoughHalfSpace turned_to(const RoughHalfSpace& plane, const Point3& inside) {
  const RoughVector way = step(plane.origin, inside);
  const double value = plane.normal[0] * way[0] + plane.normal[1] * way[1] + plane.normal[2] * way[2];
  if (!(std::fabs(value) > plane.error * sum_norm(way) + plane.offset)) return {{0, 0, 0}, plane.origin, 0, 0};
  return value > 0 ? plane : reversed(plane);
}

bool is_outside(const RoughHalfSpace& half_space, const Point3& point) {
  return is_outside(half_space, Box3{point, point});
}

BoxHierarchy::BoxHierarchy(std::vector<Box3> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (boxes_.empty()) return;
  branches_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(boxes_.size()));
}

void BoxHierarchy::build(std::uint32_t branch, std::uint32_t first, std::uint32_t last) {
  Box3 box = boxes_[order_[first]];
  for (std::uint32_t i = first + 1; i < last; ++i) box = joined(box, boxes_[order_[i]]);
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

void BoxHierarchy::search(std::span<const RoughHalfSpace> half_spaces, std::vector<std::uint32_t>& found) const {
  found.clear();
  if (branches_.empty()) return;
  const auto is_out = [&](const Box3& box) {
    for (const RoughHalfSpace& h : half_spaces) {
      if (is_outside(h, box)) return true;
    }
    return false;
  };
  std::array<std::uint32_t, 128> stack{};
  std::size_t depth = 1;
  while (depth > 0) {
    const Branch& branch = branches_[stack[--depth]];
    if (is_out(branch.box)) continue;
    for (std::uint32_t i = 0; i < branch.count; ++i) {
      const std::uint32_t n = order_[branch.first + i];
      if (branch.count == 1 || !is_out(boxes_[n])) found.push_back(n);
    }
    if (branch.count > 0) continue;
    stack[depth++] = branch.first;
    stack[depth++] = branch.first + 1;
  }
}

}  // namespace gnomon::event
