#include "geometry/bodies/closed_surface.h"

#include <algorithm>

#include "geometry/numbers/kernel.h"

namespace gnomon {
namespace {

using Triangle = std::array<Point3, 3>;

/// Seen against the x axis: the sign of the turn from a over b to p, as if p lay a little higher in z and, by much less
/// still, in y. So it is 0 only where a and b coincide.
int perturbed_turn(const Point3& a, const Point3& b, const Point3& p) {
  using Flat = InputKernel::Point_2;
  const int turn = static_cast<int>(CGAL::orientation(Flat(a.y, a.z), Flat(b.y, b.z), Flat(p.y, p.z)));
  if (turn != 0) return turn;
  if (a.y != b.y) return a.y < b.y ? 1 : -1;
  if (a.z != b.z) return a.z < b.z ? -1 : 1;
  return 0;
}

bool is_beside(const Triangle& t, const Point3& p) {
  const auto all = [&](auto claim) { return claim(t[0]) && claim(t[1]) && claim(t[2]); };
  return all([&](const Point3& q) { return q.y < p.y; }) || all([&](const Point3& q) { return q.y > p.y; }) ||
         all([&](const Point3& q) { return q.z < p.z; }) || all([&](const Point3& q) { return q.z > p.z; });
}

int orientation(const Triangle& t, const Point3& p) {
  return static_cast<int>(CGAL::orientation(to_cgal(t[0]), to_cgal(t[1]), to_cgal(t[2]), to_cgal(p)));
}

bool lies_on(const Point3& p, const Triangle& t) {
  if (orientation(t, p) != 0) return false;
  const InputKernel::Triangle_3 triangle(to_cgal(t[0]), to_cgal(t[1]), to_cgal(t[2]));
  return !triangle.is_degenerate() && triangle.has_on(to_cgal(p));
}

/// How often, with sign, the ray from p along the x axis leaves through the triangle, unless p lies on it.
int crossing(const Triangle& t, const Point3& p) {
  const int turn = perturbed_turn(t[0], t[1], p);
  if (turn == 0 || perturbed_turn(t[1], t[2], p) != turn || perturbed_turn(t[2], t[0], p) != turn) return 0;
  return orientation(t, p) == -turn ? turn : 0;
}

}  // namespace

bool is_strictly_inside(const Point3& point, const ClosedSurface& surface) {
  int windings = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const Triangle triangle{surface.vertices[a], surface.vertices[b], surface.vertices[c]};
    if (is_beside(triangle, point)) continue;
    if (lies_on(point, triangle)) return false;
    windings += crossing(triangle, point);
  }
  return windings != 0;
}

}  // namespace gnomon
