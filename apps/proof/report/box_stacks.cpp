#include "apps/proof/report/box_stacks.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace gnomon::report {
namespace {

constexpr double pitch = 4;
constexpr double box_height = 0.5;
constexpr int boxes_in_stack = 8;
constexpr double degree = std::numbers::pi / 180;

struct Vector {
  double x, y, z;
};

/// Multiples of 2^-12, so that sums of a few of them are exact.
double coarse(double x) {
  return std::round(x * 4096) / 4096;
}

void add_box(BoxStacks& stacks, double x, double y, double z, double turn, double half) {
  const double c = coarse(half * std::cos(turn)), s = coarse(half * std::sin(turn));
  const double z1 = z + box_height;
  const Point3 low[] = {{x + c, y + s, z}, {x - s, y + c, z}, {x - c, y - s, z}, {x + s, y - c, z}};
  std::vector<Point3> points, top, bottom;
  for (int i = 0; i < 4; ++i) {
    const Point3 a = low[i], b = low[(i + 1) % 4];
    points.push_back(a);
    points.push_back({a.x, a.y, z1});
    top.push_back({a.x, a.y, z1});
    bottom.insert(bottom.begin(), a);
    stacks.receivers.push_back(ConvexPolygon::from_points({a, b, {b.x, b.y, z1}, {a.x, a.y, z1}}));
  }
  stacks.receivers.push_back(ConvexPolygon::from_points(top));
  stacks.receivers.push_back(ConvexPolygon::from_points(bottom));
  stacks.boxes.emplace_back(ConvexSolid::hull_of(points));
}

}  // namespace

BoxStacks box_stacks(std::size_t k) {
  BoxStacks stacks;
  const double side = pitch * static_cast<double>(k);
  stacks.receivers.push_back(ConvexPolygon::from_points(
      {{-side, -side, 0}, {2 * side, -side, 0}, {2 * side, 2 * side, 0}, {-side, 2 * side, 0}}));
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) {
      for (int n = 0; n < boxes_in_stack; ++n) {
        // Twists differ from box to box, and a little from stack to stack.
        const double twist = 7.0 * n + 1.5 * static_cast<double>((3 * i + 5 * j) % 11);
        const double turn = (90.0 * static_cast<double>((i + j) % 4) + twist) * degree;
        add_box(stacks, pitch * (static_cast<double>(i) + 0.5), pitch * (static_cast<double>(j) + 0.5), n * box_height,
                turn, 1.25 - 0.0625 * n);
      }
    }
  }
  return stacks;
}

Light distant_hexagon(std::size_t k) {
  const double middle = pitch * static_cast<double>(k) / 2, distance = 1000 * pitch;
  const double azimuth = 210 * degree, elevation = 65 * degree;
  const Vector way{std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth),
                   std::sin(elevation)};
  const double radius = distance * std::tan(16.0 / 60 * degree);
  // Two vectors of the plane, with coarse coordinates: sums of whole multiples of them stay exact.
  const Vector u{coarse(radius * std::cos(azimuth) / 2), coarse(-radius * std::sin(azimuth) / 2), 0};
  const Vector v{coarse(-radius * way.z * std::sin(azimuth) / 2), coarse(-radius * way.z * std::cos(azimuth) / 2),
                 coarse(radius * std::cos(elevation) / 2)};
  const Point3 centre{coarse(middle + distance * way.x), coarse(middle + distance * way.y), coarse(distance * way.z)};
  // A hexagon with vertices at (+-2, 0) and (+-1, +-7/4), nearly regular.
  std::vector<Point3> points;
  for (const auto& [a, b] :
       {std::pair(2.0, 0.0), {1.0, 1.75}, {-1.0, 1.75}, {-2.0, 0.0}, {-1.0, -1.75}, {1.0, -1.75}}) {
    points.push_back({centre.x + a * u.x + b * v.x, centre.y + a * u.y + b * v.y, centre.z + a * u.z + b * v.z});
  }
  return AreaLight{ConvexPolygon::from_points(points), true};
}

Light square_above(std::size_t k) {
  const double middle = pitch * static_cast<double>(k) / 2, z = 3 * boxes_in_stack * box_height;
  return AreaLight{ConvexPolygon::from_points({{middle - 4, middle - 4, z},
                                               {middle - 4, middle + 4, z},
                                               {middle + 4, middle + 4, z},
                                               {middle + 4, middle - 4, z}}),
                   false};
}

}  // namespace gnomon::report
