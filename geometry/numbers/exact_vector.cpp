#include "geometry/numbers/exact_vector.h"

namespace gnomon {

Quadruple<Integer> whole_coordinates(const ExactVector& p) {
  const Integer w = lcm(lcm(denominator(p.x), denominator(p.y)), denominator(p.z));
  const auto whole = [&](const Rational& x) -> Integer { return numerator(x) * (w / denominator(x)); };
  return {whole(p.x), whole(p.y), whole(p.z), w};
}

Rational ExactPlane::height(const ExactVector& p) const {
  return dot(normal, p) + offset;
}

ExactPlane plane_through(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
  const ExactVector normal = cross(b - a, c - a);
  return {normal, -dot(normal, a)};
}

ExactVector doubled_area(const ExactPolygon& polygon) {
  ExactVector sum;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum = sum + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return sum;
}

}  // namespace gnomon
