#include "tests/geometry/discontinuity/mesh_cases.h"

#include <utility>

namespace gnomon::test_support {
namespace {

using Points = std::vector<Point3>;

/// Adds the triangle unless its points are in line.
void add_triangle(SideCase& drawn, const Point3& a, const Point3& b, const Point3& c) {
  const Points points{a, b, c};
  if (!ConvexPolygon::defect(points)) drawn.blockers.emplace_back(ConvexPolygon::from_points(points));
}

class MeshDrawer {
 public:
  explicit MeshDrawer(Dice& dice) : dice_(dice), is_shaken_(dice.once_in(3)) {}

  void add_sheet(SideCase& drawn) {
    const int nx = dice_.draw(1, 3), ny = dice_.draw(1, 2);
    Points points;
    for (int y = 0; y <= ny; ++y) {
      for (int x = 0; x <= nx; ++x) points.push_back(point(x - 1, y - 1));
    }
    const auto at = [&](int x, int y) { return points[static_cast<std::size_t>(y * (nx + 1) + x)]; };
    for (int y = 0; y < ny; ++y) {
      for (int x = 0; x < nx; ++x) {
        const int turn = dice_.draw(0, 1);
        if (!dice_.once_in(5)) add_triangle(drawn, at(x, y), at(x + 1, y), at(x + 1 - turn, y + 1));
        if (!dice_.once_in(5)) add_triangle(drawn, at(x + turn, y), at(x + 1, y + 1), at(x, y + 1));
      }
    }
  }

  void add_double_pyramid(SideCase& drawn) {
    const Point3 low = point(dice_.draw(-1, 1), dice_.draw(-1, 1)), high = point(dice_.draw(-1, 1), 0);
    Points ring{point(2, 0), point(0, 2), point(-1, 0), point(0, -1)};
    if (dice_.once_in(2)) ring.pop_back();
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point3 &p = ring[k], &q = ring[(k + 1) % ring.size()];
      add_triangle(drawn, p, q, high);
      add_triangle(drawn, q, p, low);
    }
  }

  void add_leaves(SideCase& drawn) {
    Points points;
    for (int n = dice_.draw(3, 5); n > 0; --n) points.push_back(point(dice_.draw(-1, 2), dice_.draw(-1, 2)));
    for (int n = dice_.draw(2, 6); n > 0; --n) {
      add_triangle(drawn, dice_.one_of(points), dice_.one_of(points), dice_.one_of(points));
    }
  }

  AreaLight lamp() {
    const double x = dice_.draw(-2, 1), y = dice_.draw(-2, 1), z = 4;
    const double wide = dice_.draw(1, 8) / 4.0 * dice_.draw(1, 2), deep = dice_.draw(1, 4) / 2.0;
    const double tilt = dice_.once_in(3) ? 0.5 : 0;
    Points points{{x, y, z}, {x, y + deep, z}, {x + wide, y + deep, z + tilt}, {x + wide, y, z + tilt}};
    if (dice_.once_in(3)) points.pop_back();
    return {ConvexPolygon::from_points(points), dice_.once_in(4)};
  }

 private:
  Point3 point(double x, double y) {
    const auto shake = [&] { return is_shaken_ ? dice_.draw(-999, 999) * 0x1p-12 : dice_.once_in(4) ? 0.5 : 0; };
    return {x + shake(), y + shake(), dice_.draw(1, 2) + shake()};
  }

  Dice& dice_;
  bool is_shaken_;
};

}  // namespace

SideCase mesh_under_lamp(Dice& dice) {
  MeshDrawer drawer(dice);
  SideCase drawn{drawer.lamp(), {}, {}};
  while (drawn.blockers.empty()) {
    const int kind = dice.draw(0, 3);
    if (kind < 2) drawer.add_sheet(drawn);
    if (kind == 2) drawer.add_double_pyramid(drawn);
    if (kind == 3) drawer.add_leaves(drawn);
  }
  for (const double z : {0.0, 1.0}) {
    drawn.receivers.push_back(ConvexPolygon::from_points({{-5, -5, z}, {5, -5, z}, {5, 5, z}, {-5, 5, z}}));
  }
  return drawn;
}

}  // namespace gnomon::test_support
