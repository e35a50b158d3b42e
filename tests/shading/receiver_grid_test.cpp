#include "shading/receiver_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shading/light_irradiance.h"
#include "tests/support/dice.h"

namespace gnomon {
namespace {

using test_support::Dice;

ConvexPolygon polygon(std::vector<Point3> points) {
  return ConvexPolygon::from_points(std::move(points));
}

TEST(ReceiverGrid, OfARectangleRunsAlongItsFirstSideThenInwards) {
  const ReceiverGrid grid(polygon({{-2, 1, 0}, {2, 1, 0}, {2, 5, 0}, {-2, 5, 0}}), {4, 2});
  ASSERT_EQ(grid.size(), 8u);
  EXPECT_EQ(grid.point(0), (Point3{-1.5, 2, 0}));
  EXPECT_EQ(grid.point(1), (Point3{-0.5, 2, 0}));
  EXPECT_EQ(grid.point(7), (Point3{1.5, 4, 0}));
  EXPECT_EQ(grid.normal(), (Point3{0, 0, 1}));
}

TEST(ReceiverGrid, ItsNormalPointsToWhereTheVerticesRunCounterclockwise) {
  const ReceiverGrid grid(polygon({{-2, 1, 0}, {-2, 5, 0}, {2, 5, 0}, {2, 1, 0}}), {1, 1});
  EXPECT_EQ(grid.normal(), (Point3{0, 0, -1}));
  EXPECT_EQ(grid.point(0), (Point3{0, 3, 0}));
}

TEST(ReceiverGrid, OfATriangleKeepsWhatLiesOnIt) {
  const ReceiverGrid grid(polygon({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}), {4, 4});
  int on = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Point3 p = grid.point(i);
    EXPECT_EQ(grid.is_on_receiver(p), p.x + p.y <= 4);
    on += grid.is_on_receiver(p) ? 1 : 0;
  }
  EXPECT_EQ(on, 10) << "the middles on the slanted side count";
}

/// A random tilted rectangle that is a blocker too: doubles near it lie before and behind it.
TEST(ReceiverGridProperty, ATiltedReceiverThatBlocksDoesNotDarkenItself) {
  Dice dice(5);
  for (int round = 0; round < 200; ++round) {
    const auto small = [&] { return dice.draw(-999, 999) / 1777.0; };
    const Point3 a{small(), small(), small()};
    const Point3 b{a.x + 2 + small(), a.y + small(), a.z + small()};
    const Point3 c{a.x + small(), a.y + 2 + small(), a.z + small()};
    const ConvexPolygon floor = polygon({a, b, c});
    const AreaLight lamp{polygon({{-1, -1, 9}, {-1, 1, 9}, {1, 1, 9}, {1, -1, 9}})};
    const ReceiverGrid grid(floor, {5, 5});
    LightIrradiance bare(lamp, 1, PreparedObstacles({}));
    LightIrradiance before(lamp, 1, PreparedObstacles(obstacles_before(floor, {{floor}, {}})));
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const Irradiance e = before.at(grid.point(i), grid.normal());
      ASSERT_EQ(e.value, bare.at(grid.point(i), grid.normal()).value);
      ASSERT_GT(e.value, 0);
    }
  }
}

TEST(ReceiverGrid, SquaresOfAnySizeHaveFourPointsAndAUnitNormal) {
  for (const double side : {5e-323, 1e-170, 1e-90, 1.0, 1e80, 1e160, 1e300}) {
    const ReceiverGrid grid(polygon({{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}}), {2, 2});
    EXPECT_EQ(grid.normal(), (Point3{0, 0, 1})) << side;
    for (std::size_t i = 0; i < grid.size(); ++i) EXPECT_TRUE(grid.is_on_receiver(grid.point(i))) << side;
    EXPECT_NEAR(grid.point(3).x / side, 0.75, side < 1e-300 ? 0.1 : 1e-15) << side;
  }
}

TEST(ReceiverGrid, AnAlmostStraightCornerDoesNotTurnTheNormal) {
  const ReceiverGrid grid(polygon({{0, 0, 0}, {3, 5, 8}, {6, 10 + 0x1p-48, 16 + 0x1p-48}, {0, 7, 7}}), {2, 2});
  EXPECT_NEAR(grid.normal().x, -1 / std::sqrt(3), 1e-15);
  EXPECT_NEAR(grid.normal().y, -1 / std::sqrt(3), 1e-15);
  EXPECT_NEAR(grid.normal().z, 1 / std::sqrt(3), 1e-15);
}

TEST(ReceiverGrid, KeepsTheObstaclesThatReachBeforeItsPlane) {
  const ConvexPolygon floor = polygon({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
  const ConvexBlocker above = polygon({{0, 0, -1}, {1, 0, -1}, {0, 0, 1}});
  const ConvexBlocker below = ConvexSolid::hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}});
  const ClosedSurface standing{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                               {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}}};
  ClosedSurface hovering = standing;
  for (Point3& p : hovering.vertices) p.z += 1;
  const Obstacles kept = obstacles_before(floor, {{above, below, floor}, {standing, hovering}});
  ASSERT_EQ(kept.blockers.size(), 1u);
  EXPECT_TRUE(std::holds_alternative<ConvexPolygon>(kept.blockers[0]));
  ASSERT_EQ(kept.enclosures.size(), 1u);
  EXPECT_EQ(kept.enclosures[0].vertices[0].z, 1);
}

}  // namespace
}  // namespace gnomon
