#include "geometry/spatial/plane_coefficients.h"

#include "geometry/rounding.h"
#include "geometry/spatial/exact_point.h"

namespace gnomon {

std::array<ExactNumber, 4> plane_coefficients(const HalfSpace& half_space) {
  const ExactPoint a = exact_point(half_space.plane[0]);
  const ExactPoint along = difference(exact_point(half_space.plane[1]), a);
  const ExactPoint third = exact_point(half_space.plane[2]);
  const ExactPoint normal = cross(along, half_space.third_is_direction ? third : difference(third, a));
  return {exact_number(normal[0]), exact_number(normal[1]), exact_number(normal[2]),
          exact_number(Rational(-dot(normal, a)))};
}

}  // namespace gnomon
