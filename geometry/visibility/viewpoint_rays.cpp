#include "geometry/visibility/viewpoint_rays.h"

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/orientation.h"

namespace gnomon::viewpoint {
namespace {

ExactVector exact_normal(const Point3& apex, const Plane& plane) {
  return cross(exact(*plane.from) - exact(apex), exact(*plane.to) - exact(apex));
}

bool same_edge(const Plane& a, const Plane& b) {
  return (*a.from == *b.from && *a.to == *b.to) || (*a.from == *b.to && *a.to == *b.from);
}

}  // namespace

int exact_side(const Point3& apex, const Plane& plane, const Ray& ray) {
  if (*ray.point == *plane.from || *ray.point == *plane.to) return 0;
  return exact_orientation(apex, *plane.from, *plane.to, *ray.point);
}

int exact_triple(const Point3& apex, const Plane& a, const Plane& b, const Plane& c) {
  // Where parts of a mesh meet, two of the planes are one: no arithmetic is needed to see it.
  if (same_edge(a, b) || same_edge(b, c) || same_edge(a, c)) return 0;
  const ExactVector p = exact_normal(apex, a);
  const ExactVector q = exact_normal(apex, b);
  const ExactVector r = exact_normal(apex, c);
  return dot(p, cross(q, r)).sign();
}

}  // namespace gnomon::viewpoint
