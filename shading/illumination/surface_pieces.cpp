#include "shading/illumination/surface_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "geometry/numbers/exact_vector.h"
#include "geometry/numbers/orientation.h"
#include "geometry/numbers/rounding.h"

namespace gnomon::illumination {
namespace {

std::vector<Point3> corners_of(const ConvexPolygon& polygon) {
  std::vector<Point3> corners;
  for (const std::uint32_t k : polygon.corners()) corners.push_back(polygon.points()[k]);
  return corners;
}

std::vector<ConvexPolygon> flat_parts(const ConvexPolygon& polygon) {
  if (polygon.is_flat()) return {polygon};
  std::vector<ConvexPolygon> parts;
  const std::vector<Point3> c = corners_of(polygon);
  for (std::size_t k = 2; k < c.size(); ++k) parts.push_back(ConvexPolygon::from_points({c[0], c[k - 1], c[k]}));
  return parts;
}

std::vector<Point3> in_order(std::span<const Point3> points) {
  std::vector<Point3> sorted(points.begin(), points.end());
  std::ranges::sort(sorted, {}, [](const Point3& p) { return std::tuple(p.x, p.y, p.z); });
  return sorted;
}

double largest_coordinate(std::span<const Point3> points) {
  double largest = 0;
  for (const Point3& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return largest;
}

double boundary_length(std::span<const Point3> ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) sum += sum_norm(step(ring[k], ring[(k + 1) % ring.size()]));
  return sum;
}

}  // namespace

double area_of(const ConvexPolygon& polygon) {
  ExactPolygon ring;
  for (const std::uint32_t k : polygon.corners()) ring.push_back(exact(polygon.points()[k]));
  const ExactVector doubled = doubled_area(ring);
  // Scaled, so that squares neither overflow nor vanish.
  const double x = nearest_double(doubled.x), y = nearest_double(doubled.y), z = nearest_double(doubled.z);
  return std::hypot(x, y, z) / 2;
}

bool are_of_one_plate(const Piece& a, const Piece& b) {
  return !a.plate.empty() && a.plate == b.plate;
}

std::vector<Piece> flat_pieces(std::span<const ViewSurface> surfaces) {
  std::vector<Piece> pieces;
  for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
    for (const ConvexPolygon& polygon : surfaces[s]) {
      const std::vector<Point3> plate = polygon.is_flat() ? std::vector<Point3>{} : in_order(polygon.points());
      for (ConvexPolygon& part : flat_parts(polygon)) {
        const double area = area_of(part);
        pieces.push_back({std::move(part), s, area, plate});
      }
    }
  }
  return pieces;
}

PartBefore part_before(const ConvexPolygon& piece, const ConvexPolygon& other) {
  const std::vector<Point3> ring = corners_of(piece), plane = corners_of(other);
  std::vector<int> sides;
  for (const Point3& p : ring) sides.push_back(exact_orientation(plane[0], plane[1], plane[2], p));
  if (std::ranges::none_of(sides, [](int s) { return s > 0; })) return {};
  if (std::ranges::none_of(sides, [](int s) { return s < 0; })) return {{ring}, 0};
  const ExactPlane cut = plane_through(exact(plane[0]), exact(plane[1]), exact(plane[2]));
  std::vector<Point3> kept;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const std::size_t next = (k + 1) % ring.size();
    if (sides[k] >= 0) kept.push_back(ring[k]);
    if (sides[k] * sides[next] >= 0) continue;
    const ExactVector p = exact(ring[k]), q = exact(ring[next]);
    const Rational at_p = cut.height(p), at_q = cut.height(q);
    const ExactVector x = p + Rational(at_p / (at_p - at_q)) * (q - p);
    kept.push_back({nearest_double(x.x), nearest_double(x.y), nearest_double(x.z)});
  }
  const double rounding = boundary_length(kept) * largest_coordinate(kept) * 0x1p-51;
  return {{kept}, rounding};
}

}  // namespace gnomon::illumination
