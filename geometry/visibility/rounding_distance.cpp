#include "geometry/visibility/rounding_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/exact_vector.h"
#include "geometry/visibility/viewpoint_rays.h"

namespace gnomon::viewpoint {
namespace {

/// What rounding may have moved a coordinate by, in units of the larger of the sizes involved.
constexpr double rounding = 8 * unit;

/// Of corners that were rounded off their plane, that of three which lie far apart.
ExactPlane plane_of(std::span<const Point3> corners) {
  const std::array<std::uint32_t, 3> k =
      corners.size() == 3 ? std::array<std::uint32_t, 3>{0, 1, 2} : polygon_plane(corners)->vertices;
  return plane_through(exact(corners[k[0]]), exact(corners[k[1]]), exact(corners[k[2]]));
}

/// By how much each coordinate may be off.
Vector doubt(std::span<const Point3> corners, const Point3& p) {
  Vector largest{std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)};
  for (const Point3& q : corners) {
    largest = {std::max(largest.x, std::fabs(q.x)), std::max(largest.y, std::fabs(q.y)),
               std::max(largest.z, std::fabs(q.z))};
  }
  return {rounding * largest.x, rounding * largest.y, rounding * largest.z};
}

/// False only if the point is certainly far from the plane, seen in doubles: a thousand times what rounding does.
bool may_be_near(std::span<const Point3> corners, const Point3& p, const Vector& off) {
  const Vector normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double reach = std::fabs(normal.x) * off.x + std::fabs(normal.y) * off.y + std::fabs(normal.z) * off.z;
  const double height = std::fabs(dot(normal, p - corners[0]));
  const double size = size_of(corners[1] - corners[0]) * size_of(corners[2] - corners[0]) * size_of(p - corners[0]);
  return !(height > 2 * reach + 64 * unit * size);
}

Rational magnitude(const Rational& a) {
  return a < 0 ? Rational(-a) : a;
}

/// How far the height over a plane changes at most within the doubt.
Rational reach(const ExactVector& normal, const Vector& off) {
  return magnitude(normal.x) * Rational(off.x) + magnitude(normal.y) * Rational(off.y) +
         magnitude(normal.z) * Rational(off.z);
}

/// What lies beyond a side, in the polygon's plane.
struct Outside {
  ExactVector corner;
  ExactVector outward;

  Outside(std::span<const Point3> corners, std::size_t side) : corner(exact(corners[side])) {
    const ExactPlane plane = plane_of(corners);
    outward = cross(exact(corners[side + 1 == corners.size() ? 0 : side + 1]) - corner, plane.normal);
  }
  Rational beyond(const Point3& p) const { return dot(outward, exact(p) - corner); }
};

}  // namespace

Nearness nearness(std::span<const Point3> corners, const Point3& p) {
  const Vector off = doubt(corners, p);
  if (!may_be_near(corners, p, off)) return Nearness::apart;
  const ExactVector at = exact(p);
  const ExactPlane plane = plane_of(corners);
  if (magnitude(plane.height(at)) > reach(plane.normal, off)) return Nearness::apart;
  Nearness result = Nearness::inside;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const ExactVector a = exact(corners[k]);
    const ExactVector outward = cross(exact(corners[k + 1 == corners.size() ? 0 : k + 1]) - a, plane.normal);
    const Rational beyond = dot(outward, at - a);
    const Rational least = reach(outward, off);
    if (beyond > least) return Nearness::apart;
    if (beyond >= -least) result = Nearness::at_side;
  }
  return result;
}

bool is_near_side(std::span<const Point3> corners, std::size_t side, const Point3& p) {
  const Outside outside(corners, side);
  return magnitude(outside.beyond(p)) <= reach(outside.outward, doubt(corners, p));
}

bool reaches_beyond(std::span<const Point3> corners, std::size_t side, std::span<const Point3> points) {
  const Outside outside(corners, side);
  return std::any_of(points.begin(), points.end(),
                     [&](const Point3& p) { return outside.beyond(p) > reach(outside.outward, doubt(corners, p)); });
}

bool faces_alike(std::span<const Point3> corners, const Point3& normal, bool one_sided) {
  const ExactVector a = plane_of(corners).normal;
  const ExactVector b = exact(normal);
  const Rational product = dot(a, b);
  if (one_sided && product <= 0) return false;
  return 4 * product * product >= dot(a, a) * dot(b, b);
}

}  // namespace gnomon::viewpoint
