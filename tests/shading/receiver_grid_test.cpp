#include "shading/receiver_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gnomon/irradiance.h"
#include "tests/support/dice.h"

namespace gnomon {
namespace {

using test_support::Dice;

ConvexPolygon polygon(std::vector<Point3> points) {
  return ConvexPolygon::from_points(std::move(points));
}

TEST(ReceiverGrid, KnowsWherePlacesOverflow) {
  const auto square = [](double half) {
    return ConvexPolygon::from_points({{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}});
  };
  EXPECT_TRUE(ReceiverGrid(square(1), {3, 3}).has_finite_points());
  EXPECT_TRUE(ReceiverGrid(square(1e-300), {1, 1}).has_finite_points());
  EXPECT_TRUE(ReceiverGrid(square(8e307), {3, 3}).has_finite_points());
  EXPECT_FALSE(ReceiverGrid(square(1.7e308), {3, 3}).has_finite_points());
  EXPECT_FALSE(ReceiverGrid(square(1e308), {1, 1}).has_finite_points());
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
    LightIrradiance itself(lamp, 1, PreparedObstacles({{floor}, {}}));
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const Irradiance e = itself.received({grid.point(i), facet_front(floor)}, grid.normal());
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

TEST(ReceiverGrid, TheMeanOfCornersNeitherOverflowsNorLeavesThem) {
  const Point3 mean = mean_of_corners(polygon({{-1e308, 0, 0}, {1e308, 0, 0}, {0, 3, 0}}));
  EXPECT_EQ(mean.y, 1);
  EXPECT_LE(std::fabs(mean.x), 1e293);
}

TEST(ReceiverGrid, PointsMoveAlongNormalsOfAnyLength) {
  for (const double size : {1e-200, 1.0, 1e200}) {
    const Point3 p = moved_along({1, 2, 3}, {0, 3 * size, 4 * size}, 0.5);
    EXPECT_NEAR(p.y, 2.3, 1e-15);
    EXPECT_NEAR(p.z, 3.4, 1e-15);
  }
}

}  // namespace
}  // namespace gnomon
