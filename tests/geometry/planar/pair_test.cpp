#include "gnomon/flatland_pair.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "gnomon/errors.h"

namespace gnomon::planar {
namespace {

using Points = std::vector<Point2>;

Position position_of(const Points& light, const Points& blocker = {{-1, 0}, {1, 0}}) {
  return pair_position(Pair::from_points(light, blocker));
}

TEST(PlanarPair, KeepsTheEndsInTheOrderGiven) {
  const Pair pair = Pair::from_points(Points{{2, 3}, {4, 5}}, Points{{6, 7}, {8, 9}});
  EXPECT_EQ(pair.light_end(LightVertex{1}), (Point2{4, 5}));
  EXPECT_EQ(pair.blocker_end(BlockerVertex{0}), (Point2{6, 7}));
  EXPECT_FALSE(pair.has_point_light());
  EXPECT_TRUE(Pair::from_points(Points{{2, 3}}, Points{{6, 7}, {8, 9}}).has_point_light());
}

TEST(PlanarPair, RefusesWhatIsNoLightOrNoSegment) {
  const Points segment{{0, 0}, {1, 0}};
  EXPECT_THROW(Pair::from_points(Points{}, segment), PreconditionError);
  EXPECT_THROW(Pair::from_points(Points{{1, 1}, {1, 1}}, segment), PreconditionError);
  EXPECT_THROW(Pair::from_points(Points{{1, 1}, {2, 1}, {3, 1}}, segment), PreconditionError);
  EXPECT_THROW(Pair::from_points(segment, Points{{1, 1}}), PreconditionError);
  EXPECT_THROW(Pair::from_points(segment, Points{{1, 1}, {1, 1}}), PreconditionError);
  EXPECT_THROW(Pair::from_points(segment, Points{{1, 1}, {2, 2}, {3, 3}}), PreconditionError);
}

TEST(PlanarPair, RefusesCoordinatesThatAreNotFinite) {
  const Points segment{{0, 0}, {1, 0}};
  EXPECT_THROW(Pair::from_points(Points{{0, std::numeric_limits<double>::quiet_NaN()}}, segment), PreconditionError);
  EXPECT_THROW(Pair::from_points(segment, Points{{0, 0}, {std::numeric_limits<double>::infinity(), 0}}),
               PreconditionError);
}

TEST(PlanarPosition, IsStandardIfTheLightLiesOnOneSideOfTheBlockersLine) {
  EXPECT_EQ(position_of({{-1, 2}, {1, 2}}), Position::standard);
  EXPECT_EQ(position_of({{-1, -2}, {1, -3}}), Position::standard);
  EXPECT_EQ(position_of({{5, 1}}), Position::standard);
}

TEST(PlanarPosition, IsStandardThoughTheLightsLineMeetsTheBlocker) {
  EXPECT_EQ(position_of({{0, 1}, {0, 2}}), Position::standard);
  EXPECT_EQ(position_of({{1, 1}, {1, 2}}), Position::standard);
}

TEST(PlanarPosition, TellsWhetherTheLightCrossesTheBlockerOrItsLineBeside) {
  EXPECT_EQ(position_of({{2, -1}, {2, 1}}), Position::light_crosses_blocker_plane);
  EXPECT_EQ(position_of({{1, -1}, {1, 1}}), Position::light_crosses_blocker_plane);
  EXPECT_EQ(position_of({{0, -1}, {0, 1}}), Position::both_cross);
}

TEST(PlanarPosition, IsTouchingIfAnEndOfTheLightIsOnTheBlockersLine) {
  EXPECT_EQ(position_of({{0, 0}, {0, 1}}), Position::touching);
  EXPECT_EQ(position_of({{2, 1}, {1, 0}}), Position::touching);
  EXPECT_EQ(position_of({{7, 0}, {8, -1}}), Position::touching);
}

TEST(PlanarPosition, IsCoplanarIfTheLightLiesOnTheBlockersLine) {
  EXPECT_EQ(position_of({{0, 0}, {5, 0}}), Position::coplanar);
  EXPECT_EQ(position_of({{7, 0}}), Position::coplanar);
}

TEST(PlanarPosition, IsDecidedByTheLastBitOfACoordinate) {
  const double above = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(position_of({{3, above}}), Position::standard);
  EXPECT_EQ(position_of({{3, above}, {4, 0}}), Position::touching);
  EXPECT_EQ(position_of({{3, above}, {4, -above}}), Position::light_crosses_blocker_plane);
}

}  // namespace
}  // namespace gnomon::planar
