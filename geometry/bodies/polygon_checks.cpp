#include "geometry/bodies/polygon_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <vector>

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/kernel.h"

namespace gnomon {
namespace {

using PointTriple = std::array<std::uint32_t, 3>;

ExactVector exact_difference(const Point3& p, const Point3& q) {
  return exact(p) - exact(q);
}

/// The square root of a rational number of any magnitude, to a few units of the last place; at least the smallest
/// double if the number is not zero.
double square_root(const Rational& square) {
  if (square == 0) return 0;
  auto top = numerator(square);
  auto bottom = denominator(square);
  auto exponent = static_cast<long>(msb(top)) - static_cast<long>(msb(bottom));
  if (exponent % 2 != 0) --exponent;
  if (exponent > 0) bottom <<= static_cast<unsigned long>(exponent);
  if (exponent < 0) top <<= static_cast<unsigned long>(-exponent);
  const double root = std::sqrt(CGAL::to_double(Rational(top, bottom)));
  return std::max(std::ldexp(root, static_cast<int>(exponent / 2)), std::numeric_limits<double>::denorm_min());
}

/// The points times one power of two that brings the largest coordinate near 1, so that squares neither overflow nor
/// lose what counts by underflow.
std::vector<Point3> scaled(std::span<const Point3> points) {
  double largest = 0;
  for (const Point3& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const int shift = largest > 0 ? -std::ilogb(largest) : 0;
  std::vector<Point3> result;
  result.reserve(points.size());
  for (const Point3& p : points) {
    result.push_back({std::ldexp(p.x, shift), std::ldexp(p.y, shift), std::ldexp(p.z, shift)});
  }
  return result;
}

double squared_distance(const Point3& p, const Point3& q) {
  const double x = p.x - q.x;
  const double y = p.y - q.y;
  const double z = p.z - q.z;
  return x * x + y * y + z * z;
}

/// The square of the largest distance of two points.
/// Doubles only sort out pairs: after scaling a squared distance errs by a relative 1e-15 at most (the largest one is
/// above 1e-33, so underflow does not count), and every pair within 1e-14 of the largest is compared exactly.
Rational squared_diameter(std::span<const Point3> points) {
  const std::vector<Point3> rough = scaled(points);
  double largest = 0;
  for (std::size_t i = 0; i < rough.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) largest = std::max(largest, squared_distance(rough[i], rough[j]));
  }
  Rational exact = 0;
  for (std::size_t i = 0; i < rough.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (squared_distance(rough[i], rough[j]) < largest * (1 - 1e-14)) continue;
      const ExactVector d = exact_difference(points[i], points[j]);
      exact = std::max<Rational>(exact, dot(d, d));
    }
  }
  return exact;
}

/// Index of the first value that is at least a quarter of the largest (half, for what the values are squares of).
std::uint32_t first_large(const std::vector<Rational>& squares) {
  const Rational limit = *std::max_element(squares.begin(), squares.end()) / 4;
  const auto first = std::find_if(squares.begin(), squares.end(), [&](const Rational& s) { return s >= limit; });
  return static_cast<std::uint32_t>(first - squares.begin());
}

/// As PolygonPlane says for vertices that are not coplanar. `largest` receives the largest squared distance from the
/// first vertex.
PointTriple wide_triple(std::span<const Point3> points, Rational& largest) {
  std::vector<ExactVector> from_first;
  std::vector<Rational> squares;
  for (const Point3& p : points) {
    from_first.push_back(exact_difference(p, points[0]));
    squares.push_back(dot(from_first.back(), from_first.back()));
  }
  largest = *std::max_element(squares.begin(), squares.end());
  const std::uint32_t a = first_large(squares);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ExactVector area = cross(from_first[a], from_first[i]);
    squares[i] = dot(area, area);
  }
  return {0, a, first_large(squares)};
}

/// The first vertex, the first that differs from it, and the first that is not on their line; nothing if there is none.
std::optional<PointTriple> first_triangle(std::span<const Point3> points) {
  std::uint32_t second = 1;
  while (second < points.size() && points[second] == points[0]) ++second;
  for (std::uint32_t third = second + 1; third < points.size(); ++third) {
    if (!CGAL::collinear(to_cgal(points[0]), to_cgal(points[second]), to_cgal(points[third]))) {
      return PointTriple{0, second, third};
    }
  }
  return std::nullopt;
}

/// The three points are not asked whether they lie in their own plane: only exact arithmetic could tell.
bool lie_in_plane(std::span<const Point3> points, const PointTriple& triple) {
  const auto p = to_cgal(points[triple[0]]);
  const auto q = to_cgal(points[triple[1]]);
  const auto r = to_cgal(points[triple[2]]);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (std::find(triple.begin(), triple.end(), i) != triple.end()) continue;
    if (CGAL::orientation(p, q, r, to_cgal(points[i])) != CGAL::COPLANAR) return false;
  }
  return true;
}

bool is_triangle(const Point2& p, const Point2& q, const Point2& r) {
  using Point = InputKernel::Point_2;
  return CGAL::orientation(Point(p.x, p.y), Point(q.x, q.y), Point(r.x, r.y)) != CGAL::COLLINEAR;
}

/// The axis along which the triangle shows the largest area, as far as doubles tell, among those along which it shows
/// any; every one of these is right, a large area only keeps the predicates on their fast path.
int dominant_axis(std::span<const Point3> points, const PointTriple& triple) {
  const std::vector<Point3> t = scaled(std::array{points[triple[0]], points[triple[1]], points[triple[2]]});
  int best = -1;
  double best_area = -1;
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_triangle(projected(points[triple[0]], axis), projected(points[triple[1]], axis),
                     projected(points[triple[2]], axis))) {
      continue;
    }
    const Point2 p = projected(t[0], axis), q = projected(t[1], axis), r = projected(t[2], axis);
    const double area = std::abs((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
    if (area > best_area) std::tie(best, best_area) = std::tuple(axis, area);
  }
  return best;
}

/// deviation * limit <= diameter, in squares. The diameter lies between the largest distance from the first vertex and
/// twice that, which settles all but a few polygons without looking at pairs.
bool is_within(long limit, const Rational& deviation, const Rational& from_first, std::span<const Point3> points) {
  const Rational diameter = deviation * Rational(limit) * Rational(limit);
  if (diameter <= from_first) return true;
  if (diameter > 4 * from_first) return false;
  return diameter <= squared_diameter(points);
}

PolygonPlane rounded_plane(std::span<const Point3> points) {
  Rational from_first;
  const PointTriple triple = wide_triple(points, from_first);
  const Point3& p = points[triple[0]];
  const ExactVector normal = cross(exact_difference(points[triple[1]], p), exact_difference(points[triple[2]], p));
  PolygonPlane plane{dominant_axis(points, triple), triple};
  std::ranges::sort(plane.vertices);
  Rational farthest = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Rational distance = abs(dot(normal, exact_difference(points[i], p)));
    if (distance <= farthest) continue;
    farthest = distance;
    plane.farthest = i;
  }
  const Rational deviation = farthest * farthest / dot(normal, normal);
  plane.deviation = square_root(deviation);
  plane.flatness = is_within(1000000000, deviation, from_first, points) ? Flatness::rounded
                   : is_within(100, deviation, from_first, points)      ? Flatness::bent
                                                                        : Flatness::crooked;
  return plane;
}

}  // namespace

std::optional<RepeatedVertex> repeated_vertex(std::span<const Point3> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::tuple(points[i].x, points[i].y, points[i].z); };
  std::sort(order.begin(), order.end(), [&](auto i, auto j) { return std::tuple(key(i), i) < std::tuple(key(j), j); });
  std::optional<RepeatedVertex> found;
  for (std::size_t first = 0, k = 1; k < order.size(); ++k) {
    if (key(order[k]) != key(order[first])) {
      first = k;
    } else if (!found || order[k] < found->vertex) {
      found = RepeatedVertex{order[k], order[first]};
    }
  }
  return found;
}

std::optional<PolygonPlane> polygon_plane(std::span<const Point3> points) {
  const std::optional<PointTriple> triple = first_triangle(points);
  if (!triple) return std::nullopt;
  if (!lie_in_plane(points, *triple)) return rounded_plane(points);
  return PolygonPlane{dominant_axis(points, *triple), *triple};
}

bool are_coplanar(std::span<const Point3> points) {
  const std::optional<PointTriple> triple = first_triangle(points);
  return !triple || lie_in_plane(points, *triple);
}

Point2 projected(const Point3& point, int dropped_axis) {
  if (dropped_axis == 0) return {point.y, point.z};
  if (dropped_axis == 1) return {point.z, point.x};
  return {point.x, point.y};
}

}  // namespace gnomon
