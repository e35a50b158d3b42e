#include "gnomon/pair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gnomon/errors.h"

namespace gnomon {
namespace {

ConvexPolygon unit_square(double z) {
  return ConvexPolygon::from_points({{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}});
}

/// Shines downward.
Light lamp(double z) {
  return AreaLight{ConvexPolygon::from_points({{0, 0, z}, {0, 1, z}, {1, 1, z}, {1, 0, z}}), false};
}

/// Stands upright in the plane x = 1/2 from z = low to z = low + 2.
ConvexPolygon wall(double low) {
  return ConvexPolygon::from_points({{0.5, 0, low}, {0.5, 1, low}, {0.5, 1, low + 2}, {0.5, 0, low + 2}});
}

TEST(PairPosition, LampAboveATableIsStandard) {
  EXPECT_EQ(pair_position(lamp(2), unit_square(1)), Position::standard);
  EXPECT_EQ(pair_position(PointLight{{0, 0, 2}}, unit_square(1)), Position::standard);
  EXPECT_EQ(pair_position(LinearLight{{0, 0, 2}, {0, 0, 3}}, unit_square(1)), Position::standard);
}

TEST(PairPosition, OneSidedLampBelowItsBlockerIsBehindTheLight) {
  EXPECT_EQ(pair_position(lamp(0), unit_square(1)), Position::behind_light);
  Light both = lamp(0);
  std::get<AreaLight>(both).two_sided = true;
  EXPECT_EQ(pair_position(both, unit_square(1)), Position::standard);
}

TEST(PairPosition, NamesWhatCrossesWhat) {
  EXPECT_EQ(pair_position(LinearLight{{0, 0, 0}, {0, 0, 2}}, unit_square(1)), Position::light_crosses_blocker_plane);
  EXPECT_EQ(pair_position(lamp(5), wall(0)), Position::light_crosses_blocker_plane);
  EXPECT_EQ(pair_position(lamp(1), wall(0)), Position::both_cross);
  const Light aside = AreaLight{ConvexPolygon::from_points({{3, 0, 1}, {3, 1, 1}, {4, 1, 1}, {4, 0, 1}})};
  EXPECT_EQ(pair_position(aside, wall(0)), Position::blocker_crosses_light_plane);
}

TEST(PairPosition, TouchesWhereOnlyAPlaneIsReached) {
  EXPECT_EQ(pair_position(PointLight{{9, 9, 1}}, unit_square(1)), Position::coplanar);
  EXPECT_EQ(pair_position(LinearLight{{0, 0, 1}, {0, 0, 2}}, unit_square(1)), Position::touching);
  const Light aside = AreaLight{ConvexPolygon::from_points({{3, 0, 2}, {3, 1, 2}, {4, 1, 2}, {4, 0, 2}})};
  EXPECT_EQ(pair_position(aside, wall(0)), Position::touching);
}

TEST(PairPosition, LightInTheBlockersPlaneIsCoplanar) {
  EXPECT_EQ(pair_position(lamp(1), unit_square(1)), Position::coplanar);
  EXPECT_EQ(pair_position(LinearLight{{3, 0, 1}, {4, 5, 1}}, unit_square(1)), Position::coplanar);
}

TEST(PairPositionDegenerate, OneUlpDecides) {
  const double above = std::nextafter(1.0, 2.0);
  EXPECT_EQ(pair_position(PointLight{{0.3, 0.3, above}}, unit_square(1)), Position::standard);
  EXPECT_EQ(pair_position(LinearLight{{0, 0, above}, {7, 7, 1}}, unit_square(1)), Position::touching);
  EXPECT_EQ(pair_position(LinearLight{{0, 0, above}, {7, 7, std::nextafter(1.0, 0.0)}}, unit_square(1)),
            Position::light_crosses_blocker_plane);
}

TEST(PairPosition, RefusesALinearLightWithoutLength) {
  EXPECT_THROW(pair_position(LinearLight{{0, 0, 2}, {0, 0, 2}}, unit_square(1)), PreconditionError);
}

TEST(PairPosition, OfADirectionalLightIsStandardUnlessItsRaysRunAlongTheBlocker) {
  EXPECT_EQ(pair_position(DirectionalLight{{0, 0, -1}}, unit_square(1)), Position::standard);
  EXPECT_EQ(pair_position(DirectionalLight{{1, 2, 0}}, unit_square(1)), Position::coplanar);
}

TEST(PairPosition, OfASolidSaysWhetherTheLightReachesIntoItOrTouchesIt) {
  const ConvexBlocker cube =
      ConvexSolid::hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
  EXPECT_EQ(pair_position(LinearLight{{-1, 0.5, 0.5}, {2, 0.5, 0.5}}, cube), Position::light_crosses_blocker_plane);
  EXPECT_EQ(pair_position(LinearLight{{-1, 0.5, 1}, {2, 0.5, 1}}, cube), Position::touching);
  EXPECT_EQ(pair_position(LinearLight{{-1, -1, 0.5}, {1, -1, 0.5}}, cube), Position::standard);
  EXPECT_EQ(pair_position(PointLight{{0.5, 0.5, 1}}, cube), Position::touching);
  EXPECT_EQ(pair_position(PointLight{{0.5, 0.5, 0.5}}, cube), Position::light_crosses_blocker_plane);
}

}  // namespace
}  // namespace gnomon
