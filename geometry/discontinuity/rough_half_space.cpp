#include "geometry/discontinuity/rough_half_space.h"

#include <algorithm>
#include <cmath>

namespace gnomon::event {
namespace {

/// Far more than the relative error of the few operations below, in any rounding mode.
constexpr double slack = 0x1p-46;

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

void find_boxes(const BoxHierarchy& boxes, std::span<const RoughHalfSpace> half_spaces,
                std::vector<std::uint32_t>& found) {
  const auto may_meet = [&](const Box3& box) {
    for (const RoughHalfSpace& h : half_spaces) {
      if (is_outside(h, box)) return false;
    }
    return true;
  };
  boxes.search(may_meet, found);
}

}  // namespace gnomon::event
