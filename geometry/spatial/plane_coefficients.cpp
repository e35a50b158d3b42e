#include "geometry/spatial/plane_coefficients.h"

#include "geometry/rounding.h"

namespace gnomon {
namespace {

using RationalVector = std::array<Rational, 3>;

RationalVector exact(const Point3& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

RationalVector difference(const RationalVector& a, const RationalVector& b) {
  return {Rational(a[0] - b[0]), Rational(a[1] - b[1]), Rational(a[2] - b[2])};
}

RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {Rational(a[1] * b[2] - a[2] * b[1]), Rational(a[2] * b[0] - a[0] * b[2]),
          Rational(a[0] * b[1] - a[1] * b[0])};
}

Rational dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

std::array<ExactNumber, 4> plane_coefficients(const HalfSpace& half_space) {
  const RationalVector a = exact(half_space.plane[0]);
  const RationalVector along = difference(exact(half_space.plane[1]), a);
  const RationalVector third = exact(half_space.plane[2]);
  const RationalVector normal = cross(along, half_space.third_is_direction ? third : difference(third, a));
  return {exact_number(normal[0]), exact_number(normal[1]), exact_number(normal[2]),
          exact_number(Rational(-dot(normal, a)))};
}

}  // namespace gnomon
