#include "geometry/visibility/flat_area.h"

#include "geometry/numbers/kernel.h"
#include "geometry/numbers/rounding.h"

namespace gnomon::viewpoint {

FlatArea flat_area(std::span<const Point3> corners, int u, int v) {
  Rational sum = 0;
  const Rational u0(coordinate(corners[0], u));
  const Rational v0(coordinate(corners[0], v));
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Rational pu(Rational(coordinate(corners[k], u)) - u0);
    const Rational pv(Rational(coordinate(corners[k], v)) - v0);
    const Rational qu(Rational(coordinate(corners[k + 1], u)) - u0);
    const Rational qv(Rational(coordinate(corners[k + 1], v)) - v0);
    sum += pu * qv - pv * qu;
  }
  const double doubled = std::fabs(nearest_double(sum));
  return {doubled, unit * doubled};
}

}  // namespace gnomon::viewpoint
