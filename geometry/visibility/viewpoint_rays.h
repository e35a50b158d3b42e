#pragma once

/// Rays and planes through the point that looks, in doubles, with bounds that certify signs. Private to this folder.
///
/// Left and right, clockwise and counterclockwise are in this folder as seen from beyond, by one who looks back at the
/// apex.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/numbers/vector3.h"
#include "gnomon/point.h"

namespace gnomon::viewpoint {

/// Unit roundoff of doubles.
inline constexpr double unit = 0x1p-53;

/// Exceeds what underflow can do to any determinant below, given coordinates of at most `largest`.
inline constexpr double tiny = 1e-150;
inline constexpr double largest = 1e30;

inline bool is_in_range(const Point3& p) {
  return std::max(std::max(std::fabs(p.x), std::fabs(p.y)), std::fabs(p.z)) <= largest;
}

/// Slightly more than the Euclidean norm of (1, 1, 1).
inline constexpr double root_of_three = 1.7320509;

using Vector = Vector3<double>;

inline Vector operator-(const Point3& a, const Point3& b) {
  return step(b, a);
}

/// The largest absolute coordinate.
inline double size_of(const Vector& a) {
  return std::max(std::max(std::fabs(a.x), std::fabs(a.y)), std::fabs(a.z));
}

/// The ray from the apex through an input point.
/// Exactness: each coordinate of `direction` is off by at most u times itself.
struct Ray {
  Ray() = default;
  Ray(const Point3& apex, const Point3& through)
      : direction(through - apex), size(size_of(direction)), point(&through) {}

  Vector direction;
  double size = 0;  ///< largest absolute coordinate
  const Point3* point = nullptr;
};

/// The oriented plane through the apex and two input points; its positive side lies left of the edge `from` -> `to`.
///
/// Exactness: `normal` is (from - apex) x (to - from). Each of its two products per coordinate carries three roundings
///            of factors and product, their difference one more: at most 8.5 u |from - apex| |to - from| in all, in the
///            maximum norm.
struct Plane {
  Plane() = default;
  Plane(const Ray& start, const Ray& end, std::uint32_t edge_name)
      : Plane(start, end, *end.point - *start.point, edge_name) {}

  Vector normal;
  double size = 0;        ///< at least the largest absolute coordinate of the exact normal
  double error = 0;       ///< at least the error of each coordinate
  double side_bound = 0;  ///< times a ray's size: at least the error of dot(normal, direction)
  const Point3* from = nullptr;
  const Point3* to = nullptr;
  std::uint32_t name = 0;  ///< index of the edge in its element

 private:
  /// Bound. With an error of e per coordinate of the normal, dot() errs by 3 e s from the normal, by u from the ray's
  /// coordinates and 3 u from rounding, each times three products of at most n s.
  Plane(const Ray& start, const Ray& end, const Vector& edge, std::uint32_t edge_name)
      : normal(cross(start.direction, edge)),
        error(8.6 * unit * start.size * size_of(edge) + tiny),
        from(start.point),
        to(end.point),
        name(edge_name) {
    size = size_of(normal) + error;
    side_bound = 3.1 * error + 12.5 * unit * size;
  }
};

/// The sign that doubles cannot certify: of |from - apex, to - apex, point - apex|.
int exact_side(const Point3& apex, const Plane& plane, const Ray& ray);

/// What certain_side() says of a side that doubles cannot certify.
inline constexpr std::int8_t uncertain = 2;

/// Side of the plane on which the ray runs: -1 or +1 if doubles certify it.
inline std::int8_t certain_side(const Plane& plane, const Ray& ray) {
  const double value = dot(plane.normal, ray.direction);
  const double bound = plane.side_bound * ray.size + tiny;
  return static_cast<std::int8_t>(value > bound ? 1 : value < -bound ? -1 : uncertain);
}

/// Side of the plane on which the ray runs: -1, 0 or +1, exact.
inline int side(const Point3& apex, const Plane& plane, const Ray& ray) {
  const int certain = certain_side(plane, ray);
  return certain == uncertain ? exact_side(apex, plane, ray) : certain;
}

/// The sign that doubles cannot certify: of the determinant of the three normals.
int exact_triple(const Point3& apex, const Plane& a, const Plane& b, const Plane& c);

/// Sign of the determinant of three normals, exact: where the line of a and b runs with respect to c.
///
/// Bound. The cross product errs by 2 (ea nb + na eb) from its factors and 4.1 u na nb from rounding; multiplied out,
/// 6 (ea nb nc + na eb nc + na nb ec) and 31 u na nb nc. Higher powers are in the sizes, which include the errors.
inline int triple(const Point3& apex, const Plane& a, const Plane& b, const Plane& c) {
  const double value = dot(cross(a.normal, b.normal), c.normal);
  const double bound = 6.1 * (a.error * b.size * c.size + a.size * b.error * c.size + a.size * b.size * c.error) +
                       32 * unit * a.size * b.size * c.size + tiny;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return exact_triple(apex, a, b, c);
}

}  // namespace gnomon::viewpoint
