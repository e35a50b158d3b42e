#include "geometry/discontinuity/passage.h"

#include <algorithm>

namespace gnomon::event {
namespace {

NearVector near(const EventScene& scene, PointId point) {
  const Point3& q = scene.points[point].input;
  return {Interval(q.x), Interval(q.y), Interval(q.z)};
}

/// Whether all points lie strictly on a side of a plane through `origin`; nothing where signs are not known.
std::optional<bool> all_on_side(const NearVector& normal, const NearVector& origin, std::span<const Place> points,
                                int side) {
  bool all_known = true;
  for (const Place& p : points) {
    const auto sign = certain_sign(dot(normal, p.near - origin));
    if (sign && *sign == -side) return false;
    all_known = all_known && sign && *sign != 0;
  }
  return all_known ? std::optional(true) : std::nullopt;
}

}  // namespace

std::optional<bool> certainly_passes(const EventScene& scene, const Shape& shape, const Place& light,
                                     std::span<const Place> face) {
  if (shape.is_solid) return std::nullopt;
  const std::size_t n = shape.corners.size();
  const NearVector first = near(scene, shape.corners[0]);
  const NearVector normal = cross(near(scene, shape.corners[1]) - first, near(scene, shape.corners[2]) - first);
  const int above = certain_sign(dot(normal, light.near - first)).value_or(0);
  if (above == 0) return std::nullopt;
  std::optional<bool> passes = all_on_side(normal, first, face, above);
  for (std::size_t k = 0; k < n && passes != true; ++k) {
    const NearVector a = near(scene, shape.corners[k]) - light.near,
                     b = near(scene, shape.corners[(k + 1) % n]) - light.near;
    // Seen from where the corners run counterclockwise the shape lies on the negative side.
    const std::optional<bool> here = all_on_side(cross(a, b), light.near, face, above);
    passes = here == true ? here : passes == false && here == false ? passes : std::nullopt;
  }
  return passes;
}

}  // namespace gnomon::event
