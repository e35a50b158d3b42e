#include "apps/proof/report/triangle_scenes.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "apps/proof/report/draws.h"
#include "apps/proof/report/vectors.h"

namespace gnomon::report {
namespace {

Point3 direction(Draws& draws) {
  const double z = draws.between(-1, 1);
  const double angle = draws.between(0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

ConvexPolygon triangle(Draws& draws, double radius) {
  const double z = draws.between(1, 3);
  const double x = draws.between(-1, 1);
  const double y = draws.between(-1, 1);
  const Point3 u = direction(draws);
  Point3 v = cross(u, direction(draws));
  const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  v = {v.x / length, v.y / length, v.z / length};
  std::vector<Point3> points;
  for (int k = 0; k < 3; ++k) {
    const double angle = draws.between(0, 2 * std::numbers::pi);
    const double c = radius * std::cos(angle);
    const double s = radius * std::sin(angle);
    points.push_back({x + c * u.x + s * v.x, y + c * u.y + s * v.y, z + c * u.z + s * v.z});
  }
  return ConvexPolygon::from_points(std::move(points));
}

TriangleScene drawn_scene(std::size_t n, std::size_t points, std::size_t seed) {
  Draws draws(seed);
  TriangleScene scene{{ConvexPolygon::from_points({{-.5, -.5, 4}, {-.5, .5, 4}, {.5, .5, 4}, {.5, -.5, 4}})}, {}, {}};
  const double radius = 0.9 / std::sqrt(static_cast<double>(n)) + 0.02;
  for (std::size_t i = 0; i < n; ++i) scene.blockers.emplace_back(triangle(draws, radius));
  for (std::size_t i = 0; i < points; ++i) {
    const double x = draws.between(-1, 1);
    scene.points.push_back({x, draws.between(-1, 1), 0});
  }
  return scene;
}

}  // namespace

TriangleScene triangle_scene(std::size_t n, std::size_t points) {
  return drawn_scene(n, points, n);
}

std::vector<TriangleScene> triangle_scenes(std::size_t n) {
  if (n >= 16) return {triangle_scene(n)};
  std::vector<TriangleScene> scenes;
  for (std::size_t i = 0; i < 16; ++i) scenes.push_back(drawn_scene(n, 32, n + 1000 * i));
  return scenes;
}

}  // namespace gnomon::report
