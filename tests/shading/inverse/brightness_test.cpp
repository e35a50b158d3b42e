#include "shading/inverse/brightness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/dice.h"

namespace gnomon::inverse {
namespace {

using test_support::Dice;

double share_at(std::span<const BrightPoint> points, const Point3& p) {
  double least = HUGE_VAL;
  for (const BrightPoint& point : points) {
    const Vector3<double> v = step(point.point, p);
    const Vector3<double> n = {static_cast<double>(point.normal.x), static_cast<double>(point.normal.y),
                               static_cast<double>(point.normal.z)};
    const double r = std::sqrt(dot(v, v));
    least = std::min(least, std::max(0.0, dot(n, v)) / (std::sqrt(dot(n, n)) * r * r * r * point.wanted));
  }
  return least;
}

/// The brightest place on a plane at distance d whose normal makes the angle θ with the point's: in closed form.
TEST(BrightnessAgreement, OnAPlaneItIsTheClosedForm) {
  for (int k = 0; k < 8; ++k) {
    DesignSpace space;
    const double slope = 0.25 * k;
    const std::vector<BrightPoint> points = {{{0, 0, 0}, {Rational(slope), 0, 1}, 1}};
    const auto cells = domain_cells(space, {DomainShape::polygon, {{-8, -8, 2}, {8, -8, 2}, {8, 8, 2}, {-8, 8, 2}}});
    const BrightestPosition best = brightest_position(space, cells, points);
    const double theta = std::atan(slope), c = std::cos(theta), s = std::sin(theta);
    const double u = k == 0 ? 0 : (-3 * c + std::sqrt(9 * c * c + 8 * s * s)) / (4 * s);
    EXPECT_NEAR(static_cast<double>(best.position.x), 2 * u, 1e-4);
    EXPECT_NEAR(static_cast<double>(best.position.y), 0, 1e-4);
    const double there = share_at(points, {2 * u, 0, 2});
    EXPECT_LE(there, best.most);
    EXPECT_LE(best.share, there * (1 + 1e-12));
    EXPECT_NEAR(best.share, best.most, 1e-6 * best.most);
  }
}

/// Over a wall's point no lamp in the ceiling stands on its normal, and the brightest is d / √2 away from it.
TEST(BrightnessAgreement, OfAWallItIsDByRootTwoAway) {
  DesignSpace space;
  const std::vector<BrightPoint> points = {{{0, 0, 0}, {1, 0, 0}, 1}};
  const auto cells = domain_cells(space, {DomainShape::segment, {{0.0625, 0, 2}, {8, 0, 2}}});
  const BrightestPosition best = brightest_position(space, cells, points);
  EXPECT_NEAR(static_cast<double>(best.position.x), std::sqrt(2.0), 1e-4);
}

TEST(BrightnessAgreement, NoPlaceOfALatticeIsBrighterThanTheBound) {
  for (std::uint32_t seed = 1; seed <= (GNOMON_LONG ? 500 : 40); ++seed) {
    Dice dice(seed);
    DesignSpace space;
    std::vector<BrightPoint> points;
    for (int k = dice.draw(1, 5); k > 0; --k) {
      points.push_back({{double(dice.draw(-4, 4)), double(dice.draw(-4, 4)), 0},
                        {Rational(dice.draw(-1, 1)), Rational(dice.draw(-1, 1)), 4},
                        dice.draw(1, 4) / 64.0});
    }
    const auto cells = domain_cells(space, {DomainShape::box, {{-4, -4, 4}, {4, 4, 8}}});
    const BrightestPosition best = brightest_position(space, cells, points);
    EXPECT_LE(best.share, best.most) << "seed " << seed;
    EXPECT_NEAR(best.share, best.most, 1e-5 * best.most) << "seed " << seed;
    for (int i = 0; i <= 16; ++i) {
      for (int j = 0; j <= 16; ++j) {
        EXPECT_LE(share_at(points, {-4 + i / 2.0, -4 + j / 2.0, 4}), best.most * (1 + 1e-12)) << "seed " << seed;
      }
    }
    const auto enough = [&](const BrightPoint& p) { return is_bright_enough(p, best.position); };
    EXPECT_EQ(std::ranges::all_of(points, enough), best.share >= 1) << "seed " << seed;
  }
}

}  // namespace
}  // namespace gnomon::inverse
