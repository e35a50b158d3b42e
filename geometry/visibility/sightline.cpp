#include "geometry/visibility/sightline.h"

#include "geometry/numbers/kernel.h"
#include "geometry/numbers/orientation.h"

namespace gnomon::sight {
namespace {

struct ExactVector {
  Rational x, y, z;
};

ExactVector exact_difference(const Point3& a, const Point3& b) {
  return {Rational(a.x) - Rational(b.x), Rational(a.y) - Rational(b.y), Rational(a.z) - Rational(b.z)};
}

ExactVector exact_normal(const Point3& apex, const Plane& plane) {
  const ExactVector a = exact_difference(*plane.from, apex);
  const ExactVector b = exact_difference(*plane.to, apex);
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
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
  const Rational det = p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
  return det.sign();
}

}  // namespace gnomon::sight
