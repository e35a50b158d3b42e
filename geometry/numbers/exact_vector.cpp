#include "geometry/numbers/exact_vector.h"

namespace gnomon {

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
