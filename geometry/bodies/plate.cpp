#include "geometry/bodies/plate.h"

#include <algorithm>
#include <cmath>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/vector3.h"

namespace gnomon {
namespace {

using Vector = Vector3<double>;

double length(const Vector& a) {
  return std::hypot(a.x, a.y, a.z);
}

/// True of solids a thousand times thicker than what was rounded, as doubles tell: of most.
bool is_thick(std::span<const Point3> points) {
  const auto farthest = [&](const auto& measure) {
    return *std::ranges::max_element(points, {}, [&](const Point3& p) { return measure(step(points[0], p)); });
  };
  const Vector along = step(points[0], farthest(length));
  const Vector aside = step(points[0], farthest([&](const Vector& v) { return length(cross(along, v)); }));
  const Vector normal = cross(along, aside);
  const auto height = [&](const Vector& v) { return std::fabs(dot(normal, v)); };
  return height(step(points[0], farthest(height))) > 1e-6 * length(normal) * length(along);
}

}  // namespace

std::vector<Point3> plate_ring(const ConvexSolid& solid) {
  if (is_thick(solid.points())) return {};
  const auto plane = polygon_plane(solid.points());
  if (!plane || plane->flatness > Flatness::rounded || ConvexPolygon::defect(solid.points())) return {};
  return {solid.points().begin(), solid.points().end()};
}

}  // namespace gnomon
