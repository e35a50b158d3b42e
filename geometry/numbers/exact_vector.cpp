#include "geometry/numbers/exact_vector.h"

namespace gnomon {

ExactVector operator+(const ExactVector& a, const ExactVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

ExactVector operator-(const ExactVector& a, const ExactVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

ExactVector operator*(const Rational& s, const ExactVector& a) {
  return {s * a.x, s * a.y, s * a.z};
}

Rational dot(const ExactVector& a, const ExactVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

ExactVector cross(const ExactVector& a, const ExactVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

bool is_zero(const ExactVector& a) {
  return a.x == 0 && a.y == 0 && a.z == 0;
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
