#include "apps/proof/report/polygon_pairs.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace gnomon::report {
namespace {

/// Rounded to a grid so coarse that a tilt by an eighth is exact, hence the polygon exactly flat.
double on_grid(double coordinate) {
  return std::round(coordinate * 0x1p40) * 0x1p-40;
}

std::vector<Point2> circle(std::uint32_t corners, double radius, double phase) {
  std::vector<Point2> points;
  for (std::uint32_t k = 0; k < corners; ++k) {
    const double angle = phase + 2 * std::numbers::pi * k / corners;
    points.push_back({on_grid(radius * std::cos(angle)), on_grid(radius * std::sin(angle))});
  }
  return points;
}

}  // namespace

PolygonPair generic_pair(std::uint32_t corners) {
  std::vector<Point3> light;
  for (const Point2& p : circle(corners, 1, 0.1)) light.push_back({p.x, -p.y, 4 + p.x / 8});
  std::vector<Point3> blocker;
  for (const Point2& p : circle(corners, 1.5, 0.3)) blocker.push_back({p.x, p.y, 2 - p.y / 8});
  return {AreaLight{ConvexPolygon::from_points(std::move(light))}, ConvexPolygon::from_points(std::move(blocker))};
}

PolygonPair aligned_squares() {
  return {AreaLight{ConvexPolygon::from_points({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}})},
          ConvexPolygon::from_points({{-2, -2, 2}, {2, -2, 2}, {2, 2, 2}, {-2, 2, 2}})};
}

}  // namespace gnomon::report
