#include "tests/benchmarks/mesh_models.h"

#include <cmath>
#include <random>

namespace gnomon::benchmarks {
namespace {

class Draw {
 public:
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / static_cast<double>(std::mt19937::max());
  }

 private:
  std::mt19937 engine_{1};
};

void add(Triangles& triangles, const Point3& a, const Point3& b, const Point3& c) {
  triangles.emplace_back(ConvexPolygon::from_points({a, b, c}));
}

constexpr double pi = 3.14159265358979323846;

}  // namespace

Triangles ball(std::size_t rings, std::size_t around, double least) {
  Draw draw;
  const double wobble = least < 1 ? 0.3 : 0;
  const auto point = [&](double ring, double turn) {
    const double t = pi * ring / static_cast<double>(rings), p = 2 * pi * turn / static_cast<double>(around);
    const double r = draw(least, 1);
    return Point3{r * std::sin(t) * std::cos(p), r * std::sin(t) * std::sin(p), 2 + r * std::cos(t)};
  };
  const Point3 top = point(0, 0), bottom = point(static_cast<double>(rings), 0);
  std::vector<std::vector<Point3>> grid(rings);
  for (std::size_t i = 1; i < rings; ++i) {
    for (std::size_t j = 0; j < around; ++j) {
      grid[i].push_back(
          point(static_cast<double>(i) + draw(-wobble, wobble), static_cast<double>(j) + draw(-wobble, wobble)));
    }
  }
  Triangles triangles;
  for (std::size_t j = 0; j < around; ++j) {
    const std::size_t k = (j + 1) % around;
    add(triangles, top, grid[1][j], grid[1][k]);
    add(triangles, bottom, grid[rings - 1][k], grid[rings - 1][j]);
    for (std::size_t i = 1; i + 1 < rings; ++i) {
      add(triangles, grid[i][j], grid[i + 1][j], grid[i + 1][k]);
      add(triangles, grid[i][j], grid[i + 1][k], grid[i][k]);
    }
  }
  return triangles;
}

Triangles rough_sheet(std::size_t n) {
  Draw draw;
  const double step = 4 / static_cast<double>(n);
  std::vector<std::vector<Point3>> grid(n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      grid[i].push_back({-2 + step * (static_cast<double>(i) + draw(-0.3, 0.3)),
                         -2 + step * (static_cast<double>(j) + draw(-0.3, 0.3)), 2 + step * draw(-0.3, 0.3)});
    }
  }
  Triangles triangles;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      add(triangles, grid[i][j], grid[i + 1][j], grid[i + 1][j + 1]);
      add(triangles, grid[i][j], grid[i + 1][j + 1], grid[i][j + 1]);
    }
  }
  return triangles;
}

Triangles tufts(std::size_t count) {
  Draw draw;
  Triangles triangles;
  for (std::size_t k = 0; k < count; ++k) {
    const Point3 foot{draw(-1.5, 1.5), draw(-1.5, 1.5), draw(1, 1.5)};
    for (int leaf = 0; leaf < 16; ++leaf) {
      const double turn = draw(0, 2 * pi), reach = draw(0.3, 0.8), rise = draw(0.2, 1), wide = draw(0.01, 0.05);
      const Point3 tip{foot.x + reach * std::cos(turn), foot.y + reach * std::sin(turn), foot.z + rise};
      const Point3 side{tip.x - wide * std::sin(turn), tip.y + wide * std::cos(turn), tip.z + draw(-wide, wide)};
      add(triangles, foot, tip, side);
    }
  }
  return triangles;
}

Light wide_lamp() {
  return AreaLight{ConvexPolygon::from_points({{-1, -1, 5.5}, {-1, 1, 5.5}, {1, 1, 5.5}, {1, -1, 5.5}})};
}

ConvexPolygon floor_below() {
  return ConvexPolygon::from_points({{-6, -6, 0}, {6, -6, 0}, {6, 6, 0}, {-6, 6, 0}});
}

}  // namespace gnomon::benchmarks
