#include "apps/proof/laws/exact.h"

namespace gnomon::laws {

ExactVector exact(const Point3& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

std::vector<ExactVector> exact(std::span<const Point3> points) {
  std::vector<ExactVector> result;
  for (const Point3& p : points) result.push_back(exact(p));
  return result;
}

ExactVector operator+(const ExactVector& a, const ExactVector& b) {
  return {Rational(a.x + b.x), Rational(a.y + b.y), Rational(a.z + b.z)};
}

ExactVector operator-(const ExactVector& a, const ExactVector& b) {
  return {Rational(a.x - b.x), Rational(a.y - b.y), Rational(a.z - b.z)};
}

ExactVector operator*(const Rational& s, const ExactVector& a) {
  return {Rational(s * a.x), Rational(s * a.y), Rational(s * a.z)};
}

Rational dot(const ExactVector& a, const ExactVector& b) {
  return Rational(a.x * b.x + a.y * b.y + a.z * b.z);
}

ExactVector cross(const ExactVector& a, const ExactVector& b) {
  return {Rational(a.y * b.z - a.z * b.y), Rational(a.z * b.x - a.x * b.z), Rational(a.x * b.y - a.y * b.x)};
}

int sign(const Rational& r) {
  return static_cast<int>(CGAL::sign(r));
}

bool is_zero(const ExactVector& a) {
  return sign(a.x) == 0 && sign(a.y) == 0 && sign(a.z) == 0;
}

Rational ExactPlane::height(const ExactVector& p) const {
  return Rational(dot(normal, p) - offset);
}

ExactPlane ExactPlane::reversed() const {
  return {Rational(-1) * normal, Rational(-offset)};
}

ExactPlane plane_through(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
  const ExactVector normal = cross(b - a, c - a);
  return {normal, dot(normal, a)};
}

ExactPlane plane_of(std::span<const ExactVector> polygon) {
  ExactVector twice_area;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice_area = twice_area + cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  }
  return {twice_area, dot(twice_area, polygon[0])};
}

ExactVector middle(std::span<const ExactVector> polygon) {
  ExactVector sum;
  for (const ExactVector& p : polygon) sum = sum + p;
  return Rational(1, polygon.size()) * sum;
}

std::optional<int> common_side(const ExactPlane& plane, std::span<const ExactVector> points) {
  int common = 0;
  for (const ExactVector& p : points) {
    const int side = plane.side(p);
    if (side * common < 0) return std::nullopt;
    if (side != 0) common = side;
  }
  return common;
}

}  // namespace gnomon::laws
