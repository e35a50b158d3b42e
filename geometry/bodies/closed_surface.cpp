#include "geometry/bodies/closed_surface.h"

#include <algorithm>

#include "geometry/numbers/kernel.h"

namespace gnomon {
namespace {

template <class Point>
using Triangle = std::array<Point, 3>;

/// The sign of the turn from a over b to p, seen against the x axis.
int turn(const Point3& a, const Point3& b, const Point3& p) {
  using Flat = InputKernel::Point_2;
  return static_cast<int>(CGAL::orientation(Flat(a.y, a.z), Flat(b.y, b.z), Flat(p.y, p.z)));
}
int turn(const ExactVector& a, const ExactVector& b, const ExactVector& p) {
  return Rational((b.y - a.y) * (p.z - a.z) - (b.z - a.z) * (p.y - a.y)).sign();
}

/// The sign of the volume of t and p.
int orientation(const Triangle<Point3>& t, const Point3& p) {
  return static_cast<int>(CGAL::orientation(to_cgal(t[0]), to_cgal(t[1]), to_cgal(t[2]), to_cgal(p)));
}
int orientation(const Triangle<ExactVector>& t, const ExactVector& p) {
  return dot(cross(t[1] - t[0], t[2] - t[0]), p - t[0]).sign();
}

/// As if p lay a little higher in z and, by much less still, in y. So it is 0 only where a and b coincide.
template <class Point>
int perturbed_turn(const Point& a, const Point& b, const Point& p) {
  if (const int found = turn(a, b, p); found != 0) return found;
  if (a.y != b.y) return a.y < b.y ? 1 : -1;
  if (a.z != b.z) return a.z < b.z ? -1 : 1;
  return 0;
}

template <class Point>
bool is_beside(const Triangle<Point>& t, const Point& p) {
  const auto all = [&](auto claim) { return claim(t[0]) && claim(t[1]) && claim(t[2]); };
  return all([&](const Point& q) { return q.y < p.y; }) || all([&](const Point& q) { return q.y > p.y; }) ||
         all([&](const Point& q) { return q.z < p.z; }) || all([&](const Point& q) { return q.z > p.z; });
}

bool is_of_triangle(const Triangle<Point3>& t, const Point3& p) {
  const InputKernel::Triangle_3 triangle(to_cgal(t[0]), to_cgal(t[1]), to_cgal(t[2]));
  return !triangle.is_degenerate() && triangle.has_on(to_cgal(p));
}
bool is_of_triangle(const Triangle<ExactVector>& t, const ExactVector& p) {
  const ExactVector normal = cross(t[1] - t[0], t[2] - t[0]);
  if (is_zero(normal)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (dot(cross(t[(k + 1) % 3] - t[k], p - t[k]), normal) < 0) return false;
  }
  return true;
}

/// How often, with sign, the ray from p along the x axis leaves through the triangle, unless p lies on it.
template <class Point>
int crossing(const Triangle<Point>& t, const Point& p) {
  const int way = perturbed_turn(t[0], t[1], p);
  if (way == 0 || perturbed_turn(t[1], t[2], p) != way || perturbed_turn(t[2], t[0], p) != way) return 0;
  return orientation(t, p) == -way ? way : 0;
}

template <class Point, class VertexOf>
bool winds_around(const Point& p, const ClosedSurface& surface, const VertexOf& vertex) {
  int windings = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const Triangle<Point> triangle{vertex(a), vertex(b), vertex(c)};
    if (is_beside(triangle, p)) continue;
    if (orientation(triangle, p) == 0 && is_of_triangle(triangle, p)) return false;
    windings += crossing(triangle, p);
  }
  return windings != 0;
}

}  // namespace

bool is_strictly_inside(const Point3& point, const ClosedSurface& surface) {
  return winds_around(point, surface, [&](std::uint32_t v) { return surface.vertices[v]; });
}

bool encloses(const ClosedSurface& surface, const ExactVector& point) {
  return winds_around(point, surface, [&](std::uint32_t v) { return exact(surface.vertices[v]); });
}

}  // namespace gnomon
