#include "shading/image/irradiance_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/dice.h"

namespace gnomon::image {
namespace {

/// The square from -4 to 4 of the floor, in two triangles that share corners.
MeshDrawing square() {
  MeshDrawing drawing;
  drawing.points = {{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}};
  drawing.triangles = {{{0, 1, 2}, 0}, {{0, 2, 3}, 0}};
  return drawing;
}

/// A bulb of intensity 4 that hangs 1 above the floor.
double below_a_bulb(const Point3& p) {
  return 4 / std::pow(p.x * p.x + p.y * p.y + 1, 1.5);
}

struct Painted {
  std::vector<IrradianceMesh::Corner> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

template <class Function>
Painted painted(Function irradiance, unsigned threads = 1) {
  IrradianceMesh mesh;
  mesh.add(square(), [=](std::size_t, const Point3& p) { return Irradiance{irradiance(p), 0}; });
  mesh.begin(threads);
  mesh.refine(mesh.largest(), threads);
  return {mesh.corners(), mesh.triangles()};
}

/// What is interpolated between a triangle's corners.
struct Place {
  Point3 point;
  double value = 0;
};

Place place_in(const Painted& painted, const std::array<std::uint32_t, 3>& triangle, double s, double t) {
  if (s + t > 1) s = 1 - s, t = 1 - t;
  Place place;
  const double weights[] = {1 - s - t, s, t};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [p, e] = painted.corners[triangle[k]];
    place.point = {place.point.x + weights[k] * p.x, place.point.y + weights[k] * p.y, 0};
    place.value += weights[k] * e.value;
  }
  return place;
}

double doubled_area(const Painted& painted) {
  double sum = 0;
  for (const auto& [a, b, c] : painted.triangles) {
    const Point3 &p = painted.corners[a].point, &q = painted.corners[b].point, &r = painted.corners[c].point;
    sum += (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
  }
  return sum;
}

TEST(IrradianceMesh, IsFineEnoughThatNoPlaceIsOffByAHundredthOfTheLargest) {
  const Painted fine = painted(below_a_bulb);
  test_support::Dice dice(4711);
  double worst = 0;
  for (const auto& triangle : fine.triangles) {
    const Place place = place_in(fine, triangle, dice.draw(0, 1000) / 1000.0, dice.draw(0, 1000) / 1000.0);
    worst = std::max(worst, std::fabs(place.value - below_a_bulb(place.point)));
  }
  EXPECT_LT(worst, 4.0 / 100);
  EXPECT_GT(fine.triangles.size(), 1000U);
}

TEST(IrradianceMesh, CoversWhatItIsMadeOf) {
  EXPECT_NEAR(doubled_area(painted(below_a_bulb)), 128, 1e-9);
  EXPECT_NEAR(doubled_area(painted([](const Point3&) { return 0.0; })), 128, 1e-9);
}

TEST(IrradianceMesh, HasAtACornerTheValueOfItsOwnFace) {
  // It jumps along the diagonal, which both triangles end at.
  const Painted fine = painted([](const Point3& p) { return p.y < p.x ? 3.0 : 0.0; });
  for (const auto& triangle : fine.triangles) {
    const Place middle = place_in(fine, triangle, 1.0 / 3, 1.0 / 3);
    EXPECT_EQ(middle.value, middle.point.y < middle.point.x ? 3.0 : 0.0);
  }
}

TEST(IrradianceMesh, EndsWhereItIsInfinite) {
  const Painted fine = painted([](const Point3& p) { return 1 / (p.x * p.x + p.y * p.y); });
  EXPECT_LT(fine.triangles.size(), 100000U);
}

TEST(IrradianceMesh, IsTheSameForAnyNumberOfThreads) {
  const Painted one = painted(below_a_bulb), three = painted(below_a_bulb, 3);
  EXPECT_EQ(one.triangles, three.triangles);
  ASSERT_EQ(one.corners.size(), three.corners.size());
  for (std::size_t i = 0; i < one.corners.size(); ++i) EXPECT_EQ(one.corners[i].point, three.corners[i].point);
}

}  // namespace
}  // namespace gnomon::image
