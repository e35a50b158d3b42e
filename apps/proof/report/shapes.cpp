#include "apps/proof/report/shapes.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "apps/proof/report/vectors.h"

namespace gnomon::report {
namespace {

std::vector<Point3> mapped_points(std::span<const Point3> points, double factor, const Point3& offset) {
  std::vector<Point3> result;
  for (const Point3& p : points) result.push_back(sum(scaled(factor, p), offset));
  return result;
}

/// Turned about (1, 2, 3).
Point3 turned(const Point3& p, double angle) {
  const Point3 axis = scaled(1 / std::sqrt(14.0), {1, 2, 3});
  const Point3 along = scaled(dot(p, axis) * (1 - std::cos(angle)), axis);
  return sum(sum(scaled(std::cos(angle), p), scaled(std::sin(angle), cross(axis, p))), along);
}

}  // namespace

AreaLight square_light(double half, double z) {
  return {ConvexPolygon::from_points({{-half, -half, z}, {-half, half, z}, {half, half, z}, {half, -half, z}})};
}

ConvexBlocker board(double x_min, double x_max, double y_min, double y_max, double z) {
  return ConvexPolygon::from_points({{x_min, y_min, z}, {x_max, y_min, z}, {x_max, y_max, z}, {x_min, y_max, z}});
}

ConvexBlocker diamond(double distance, double z) {
  return ConvexPolygon::from_points({{distance, 0, z}, {0, distance, z}, {-distance, 0, z}, {0, -distance, z}});
}

ConvexBlocker blade(double x, double y_min, double y_max, double z_min, double z_max) {
  return ConvexPolygon::from_points({{x, y_min, z_min}, {x, y_max, z_min}, {x, y_max, z_max}, {x, y_min, z_max}});
}

std::vector<Point3> flat_round(int corners, double radius, double z) {
  std::vector<Point3> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double x = std::ldexp(std::round(std::ldexp(radius * std::cos(angle), 40)), -40);
    const double y = std::ldexp(std::round(std::ldexp(radius * std::sin(angle), 40)), -40);
    points.push_back({x, y, z + x / 4});
  }
  return points;
}

std::vector<Point3> turned_cube(const Point3& centre, double angle) {
  std::vector<Point3> points;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) points.push_back(sum(centre, turned({x, y, z}, angle)));
    }
  }
  return points;
}

ConvexPolygon mapped(const ConvexPolygon& polygon, double factor, const Point3& offset) {
  return ConvexPolygon::from_points(mapped_points(polygon.points(), factor, offset));
}

AreaLight mapped(const AreaLight& light, double factor, const Point3& offset) {
  return {mapped(light.polygon, factor, offset), light.two_sided};
}

ConvexBlocker mapped(const ConvexBlocker& blocker, double factor, const Point3& offset) {
  if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker))
    return convex_blocker(mapped(*polygon, factor, offset));
  return ConvexSolid::hull_of(mapped_points(std::get<ConvexSolid>(blocker).points(), factor, offset));
}

}  // namespace gnomon::report
