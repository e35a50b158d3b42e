#include "apps/proof/report/paper_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "apps/proof/report/draws.h"
#include "apps/proof/report/vectors.h"
#include "geometry/numbers/vector3.h"

namespace gnomon::report {
namespace {

using PaperPlace = Vector3<double>;
using FourCorners = std::array<PaperPlace, 4>;

PaperPlace middle_of(const PaperPlace& a, const PaperPlace& b) {
  return 0.5 * (a + b);
}

PaperPlace of_unit_size(const PaperPlace& v) {
  return (1 / std::sqrt(dot(v, v))) * v;
}

Point3 at(const PaperPlace& p) {
  return {p.x, p.y, p.z};
}

void add_tetrahedra(const FourCorners& c, int depth, std::vector<ConvexBlocker>& blockers) {
  if (depth == 0) {
    for (std::size_t k = 0; k < 4; ++k) {
      blockers.emplace_back(ConvexPolygon::from_points({at(c[(k + 1) % 4]), at(c[(k + 2) % 4]), at(c[(k + 3) % 4])}));
    }
    return;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    FourCorners smaller;
    for (std::size_t i = 0; i < 4; ++i) smaller[i] = middle_of(c[k], c[i]);
    add_tetrahedra(smaller, depth - 1, blockers);
  }
}

void add_spheres(const PaperPlace& centre, double radius, const PaperPlace& up, int levels,
                 std::vector<ConvexBlocker>& blockers) {
  blockers.emplace_back(icosphere(at(centre), radius));
  if (levels == 0) return;
  const PaperPlace aside = std::fabs(up.x) < 0.9 ? PaperPlace{1, 0, 0} : PaperPlace{0, 1, 0};
  const PaperPlace first = of_unit_size(cross(up, aside)), second = cross(up, first);
  for (int k = 0; k < 9; ++k) {
    const double height = k < 6 ? 0 : std::numbers::pi / 3;
    const double round = k < 6 ? k * std::numbers::pi / 3 : (k - 6) * 2 * std::numbers::pi / 3 + std::numbers::pi / 6;
    const PaperPlace way =
        std::cos(height) * (std::cos(round) * first + std::sin(round) * second) + std::sin(height) * up;
    add_spheres(centre + (4 * radius / 3) * way, radius / 3, way, levels - 1, blockers);
  }
}

using RoundTriangle = std::array<PaperPlace, 3>;

/// An icosahedron whose triangles were parted in four twice, all corners on the unit sphere.
const std::vector<RoundTriangle>& icosphere_triangles() {
  static const std::vector<RoundTriangle> triangles = [] {
    const double g = (1 + std::sqrt(5.0)) / 2;
    std::vector<PaperPlace> corners;
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-g, g}) {
        for (const PaperPlace& p : {PaperPlace{0, a, b}, PaperPlace{a, b, 0}, PaperPlace{b, 0, a}})
          corners.push_back(of_unit_size(p));
      }
    }
    std::vector<RoundTriangle> faces;
    const double side = 1.2 * 2 / std::sqrt(1 + g * g);
    const auto near = [&](const PaperPlace& a, const PaperPlace& b) { return dot(a - b, a - b) < side * side; };
    for (std::size_t i = 0; i < 12; ++i) {
      for (std::size_t j = i + 1; j < 12; ++j) {
        for (std::size_t k = j + 1; k < 12; ++k) {
          const PaperPlace &a = corners[i], &b = corners[j], &c = corners[k];
          if (near(a, b) && near(b, c) && near(a, c)) faces.push_back({a, b, c});
        }
      }
    }
    for (int times = 0; times < 2; ++times) {
      std::vector<RoundTriangle> finer;
      for (const auto& [a, b, c] : faces) {
        const PaperPlace ab = of_unit_size(a + b), bc = of_unit_size(b + c), ca = of_unit_size(c + a);
        for (const RoundTriangle& t : {RoundTriangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
          finer.push_back(t);
      }
      faces = std::move(finer);
    }
    return faces;
  }();
  return triangles;
}

}  // namespace

ConvexSolid icosphere(const Point3& centre, double radius) {
  std::vector<Point3> corners;
  for (const RoundTriangle& triangle : icosphere_triangles()) {
    for (const PaperPlace& p : triangle) {
      corners.push_back({centre.x + radius * p.x, centre.y + radius * p.y, centre.z + radius * p.z});
    }
  }
  std::ranges::sort(corners, [](const Point3& a, const Point3& b) {
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
  });
  const auto is_near = [&](const Point3& a, const Point3& b) {
    return std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)}) < 1e-9 * radius;
  };
  // FourCorners of several triangles are the same but for rounding, and need not be neighbours in the order.
  std::vector<Point3> single;
  for (const Point3& p : corners) {
    if (std::ranges::none_of(single, [&](const Point3& q) { return is_near(p, q); })) single.push_back(p);
  }
  return ConvexSolid::hull_of(single);
}

double icosphere_deviation() {
  double least = 1;
  for (const auto& [a, b, c] : icosphere_triangles()) {
    least = std::min(least, std::fabs(dot(of_unit_size(cross(b - a, c - a)), a)));
  }
  return 1 - least;
}

PaperScene tetrahedron_pyramid(int depth, std::size_t points) {
  const double t = std::sqrt(3.0) / 2;
  const FourCorners corners{PaperPlace{0, 0.07, 0.05},
                            {1, 0.07, 0.05},
                            {0.5, 0.07 + t, 0.05},
                            {0.5, 0.07 + t / 3, 0.05 + std::sqrt(2 / 3.0)}};
  PaperScene scene{"tetrahedron", {{0.2, 0.35, 1.3}, {0.8, 0.4, 1.3}}, {}, {}};
  add_tetrahedra(corners, depth, scene.blockers);
  Draws draws(7);
  for (std::size_t i = 0; i < points; ++i) {
    const double x = draws.between(0, 1), y = draws.between(0, 1);
    scene.points.push_back({x, y, i % 2 == 0 ? 0 : draws.between(0, 0.9)});
  }
  return scene;
}

PaperScene sphereflake(int levels, std::size_t points) {
  PaperScene scene{"sphereflake", {{0.2, 0.5, 1.5}, {0.8, 0.5, 1.5}}, {}, {}};
  add_spheres({0.5, 0.5, 0.45}, 0.2, {0, 0, 1}, levels, scene.blockers);
  scene.blockers.emplace_back(ConvexPolygon::from_points({{-2, -2, 0}, {3, -2, 0}, {3, 3, 0}, {-2, 3, 0}}));
  Draws draws(7);
  for (std::size_t i = 0; i < points; ++i) {
    const double x = draws.between(-1, 2);
    scene.points.push_back({x, draws.between(-1, 2), 1e-6});
  }
  return scene;
}

}  // namespace gnomon::report
