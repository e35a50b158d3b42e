#include "geometry/visibility/silhouette.h"

namespace gnomon::viewpoint {
namespace {

/// Two coordinates in which a plane with this normal does not collapse.
void keep_two(LightPlane& plane) {
  const Vector n{std::fabs(plane.normal.x), std::fabs(plane.normal.y), std::fabs(plane.normal.z)};
  const int dropped = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
  plane.u = dropped == 0 ? 1 : 0;
  plane.v = dropped == 2 ? 1 : 2;
}

}  // namespace

LightPlane light_plane(const Point3& a, const Point3& b, const Point3& c) {
  const Vector ab = b - a;
  const Vector ac = c - a;
  LightPlane plane;
  plane.normal = cross(ab, ac);
  plane.error = 8.6 * unit * size_of(ab) * size_of(ac) + tiny;
  plane.size = size_of(plane.normal) + plane.error;
  keep_two(plane);
  return plane;
}

}  // namespace gnomon::viewpoint
