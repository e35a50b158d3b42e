#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "gnomon/errors.h"
#include "gnomon/reflection.h"
#include "tests/shading/reflection/definition_oracle.h"
#include "tests/shading/reflection/drawn_views.h"

namespace gnomon {
namespace {

using namespace test_support;

constexpr double one_rounding = 0x1p-53;

/// A light's direction above the horizon and an eye; half of them bent: a grazing eye or light, an eye that sees the
/// light mirrored to an ulp, or that looks against it.
View bent_view(Dice& dice, Point3& towards, bool is_bent) {
  towards = drawn_vector(dice);
  View view{{0, 0, 0}, added(drawn_vector(dice), dice.draw(0, 1), towards), drawn_vector(dice)};
  if (!is_bent) return view;
  view.normal = {0, 0, 1};
  towards.z = std::fabs(towards.z);
  switch (dice.draw(0, 3)) {
    case 0:
      view.to_eye.z = 1e-12;
      break;
    case 1:
      towards.z *= 1e-12;
      break;
    case 2:
      view.to_eye = mirrored(towards, view.normal);
      break;
    default:
      view.to_eye = {-towards.x, -towards.y, 1e-9};
      break;
  }
  return view;
}

void expect_close(const Irradiance& got, const Long& exact, double peak, double widest) {
  ASSERT_LE(abs(exact - got.value), Long(got.error_bound) + 1e-30 * peak);
  ASSERT_LE(got.error_bound, widest * peak);
}

class SmallReflectionAgreement : public ::testing::TestWithParam<ReflectionModel> {};

TEST_P(SmallReflectionAgreement, PointsAndDirectionsAreTheIntegrandItself) {
  Dice dice(41);
  constexpr std::array exponents = {0, 1, 2, 3, 10, 50, 200, 10000};
  for (int round = 0; round < (GNOMON_LONG ? 20000 : 1000); ++round) {
    Point3 towards;
    const View view = bent_view(dice, towards, round % 2 == 1);
    if (product(view.normal, view.to_eye) <= 0 || product(view.normal, towards) <= 0) continue;
    const int n = dice.one_of(exponents);
    const Integrated<Long> exact = integrand_towards(towards, view, GetParam(), n);
    const Long square = Long(towards.x) * towards.x + Long(towards.y) * towards.y + Long(towards.z) * towards.z;
    const double across = 1 / static_cast<double>(square);
    const bool is_halfway = GetParam() == ReflectionModel::blinn || GetParam() == ReflectionModel::blinn_classic;
    const double widest =
        is_halfway ? 1e-9 : (64 * n + 64) * one_rounding;  // H is uncertain next to the light's opposite
    const Reflection point = LightReflection(PointLight{towards}, PreparedObstacles({})).at(view, GetParam(), n);
    expect_close(point.received, exact.received / square, across, 64 * one_rounding);
    expect_close(point.lobe, exact.lobe / square, across, widest);
    const DirectionalLight sun{{-towards.x, -towards.y, -towards.z}};
    const Reflection direction = LightReflection(sun, PreparedObstacles({})).at(view, GetParam(), n);
    expect_close(direction.received, exact.received, 1, 64 * one_rounding);
    expect_close(direction.lobe, exact.lobe, 1, widest);
    if (HasFatalFailure()) FAIL() << round;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, SmallReflectionAgreement, ::testing::ValuesIn(all_models));

const View straight_view{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};

TEST(ReflectionDegenerate, AnEyeThatIsNotAboveSeesNothing) {
  LightReflection lamp(PointLight{{0, 0, 2}}, PreparedObstacles({}));
  for (const Point3& eye : {Point3{1, 0, 0}, Point3{0, 0, -1}, Point3{0.1, 0.3, -1e-300}}) {
    const Reflection r = lamp.at({{0, 0, 0}, {0, 0, 1}, eye}, ReflectionModel::phong, 8);
    EXPECT_EQ(r.received.value + r.lobe.value + r.received.error_bound + r.lobe.error_bound, 0);
  }
  EXPECT_GT(lamp.at({{0, 0, 0}, {0, 0, 1}, {1, 0, 1e-300}}, ReflectionModel::phong, 0).received.value, 0);
}

TEST(ReflectionDegenerate, OnALinearLightItIsInfinite) {
  const LinearLight light{{0, 0, 0}, {0, 0, 1}};
  const Reflection r = LightReflection(light, PreparedObstacles({})).at(straight_view, ReflectionModel::phong, 8);
  EXPECT_TRUE(std::isinf(r.lobe.error_bound));
  EXPECT_TRUE(std::isinf(reflected_radiance(r, {}, {1, 1, 1})[0].value));
}

TEST(ReflectionDegenerate, ALinearLightSeenEndOnIsOneDirection) {
  LightReflection tube(LinearLight{{0, 3, 4}, {0, 6, 8}}, PreparedObstacles({}));
  const View view{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  const Reflection r = tube.at(view, ReflectionModel::phong, 3);
  EXPECT_NEAR(r.received.value, 0.1 * 0.8, r.received.error_bound);
  EXPECT_NEAR(r.lobe.value, 0.1 * 0.8 * 0.8 * 0.8 * 0.8, r.lobe.error_bound);
  EXPECT_LT(r.lobe.error_bound, 1e-15);
}

/// A board's edge leaves 4e-16 of a light, of which doubles tell no length: that was said to be infinite.
TEST(ReflectionRegression, ASliverOfALinearLightIsNotInfinite) {
  const ConvexBlocker board =
      ConvexPolygon::from_points({{-0.5, 0.5, -2.5},
                                  {0, 0.5, -1.9999999999999998},
                                  {0.50000000000000022, 1.0000000000000002, -1.9999999999999998}});
  LightReflection tube(LinearLight{{-1, 0, -2}, {0, 0, -1}}, PreparedObstacles({{board}, {}}));
  for (const ReflectionModel model : all_models) {
    const Reflection r = tube.at({{0, 1, -2.9999999999999996}, {0, 0, 1}, {0, 0, 1}}, model, 3);
    EXPECT_LT(r.received.value + r.received.error_bound, 1e-14);
    EXPECT_LT(r.lobe.value + r.lobe.error_bound, 1e-14);
  }
}

/// A board's edge in line with a lamp's leaves slivers of 1e-16 beside the rest, whose Blinn lobe had no bound.
TEST(ReflectionRegression, SliversOfALampAreNotInfinite) {
  const AreaLight lamp{ConvexPolygon::from_points({{2, 0, 0}, {-4, -3, -2}, {0, 0, -2}}), true};
  const ConvexBlocker board =
      ConvexPolygon::from_points({{1, 0.5, -0.49999999999999994}, {-2, -1, -1.5}, {1, 2, -1.5}});
  const View view{{0, 1, -0.99999999999999989}, {0, 0, 3}, {-18, 9, 9}};
  for (const ReflectionModel model : {ReflectionModel::blinn, ReflectionModel::blinn_classic}) {
    const Reflection open = LightReflection(lamp, PreparedObstacles({})).at(view, model, 0);
    const Reflection behind = LightReflection(lamp, PreparedObstacles({{board}, {}})).at(view, model, 0);
    EXPECT_LT(behind.lobe.error_bound, 1e-9);
    EXPECT_LE(behind.lobe.value, open.lobe.value + 1e-9);
  }
}

/// The nearest end is a subnormal away, the other one 2^1075 times as far: that ended the program.
TEST(ReflectionRegression, AnEndNextToNothingAwayIsSurvived) {
  LightReflection tube(LinearLight{{0, 0, 0}, {1, 0, 2}}, PreparedObstacles({}));
  const Reflection r =
      tube.at({{0, 0, -std::numeric_limits<double>::denorm_min()}, {0, 0, 1}, {1, 0, 1}}, ReflectionModel::phong, 2);
  EXPECT_GT(r.received.value, 1e300);
}

TEST(Reflection, WithoutExponentTheCosineWeightedLobeIsTheIrradiance) {
  LightReflection tube(LinearLight{{-1, 1, 2}, {2, 1, 3}}, PreparedObstacles({}));
  const Reflection r = tube.at(straight_view, ReflectionModel::phong, 0);
  EXPECT_NEAR(r.lobe.value, r.received.value, r.lobe.error_bound + r.received.error_bound);
}

TEST(Reflection, OfAMaterialIsTheSumOfItsPartsColourByColour) {
  const Reflection parts{{2, 1e-15}, {3, 1e-15}};
  Material paint{.diffuse = {.5, 0, .25}, .specular = {0, .5, .25}, .exponent = 10};
  const RadianceRgb r = reflected_radiance(parts, paint, {1, 2, 0});
  EXPECT_NEAR(r[0].value, 1 / std::numbers::pi, r[0].error_bound);
  EXPECT_NEAR(r[1].value, 3 * 12 / (2 * std::numbers::pi), r[1].error_bound);
  EXPECT_EQ(r[2].value + r[2].error_bound, 0);
  EXPECT_LT(r[0].error_bound, 1e-14);
}

TEST(Reflection, NormsAreThoseOfTheModels) {
  EXPECT_NEAR(lobe_norm(ReflectionModel::phong, 0), 1 / std::numbers::pi, 1e-15);
  EXPECT_NEAR(lobe_norm(ReflectionModel::blinn, 0), 1 / std::numbers::pi, 1e-15);
  EXPECT_EQ(lobe_norm(ReflectionModel::phong_classic, 50), 1);
  EXPECT_EQ(lobe_norm(ReflectionModel::blinn_classic, 50), 1);
}

TEST(Reflection, WhatHasNoMeaningIsRefused) {
  LightReflection lamp(PointLight{{0, 0, 2}}, PreparedObstacles({}));
  EXPECT_THROW(lamp.at({{0, 0, 0}, {0, 0, 0}, {0, 0, 1}}, ReflectionModel::phong, 1), PreconditionError);
  EXPECT_THROW(lamp.at({{0, 0, 0}, {0, 0, 1}, {0, 0, 0}}, ReflectionModel::phong, 1), PreconditionError);
  EXPECT_THROW(lamp.at({{NAN, 0, 0}, {0, 0, 1}, {0, 0, 1}}, ReflectionModel::phong, 1), PreconditionError);
  EXPECT_THROW(lamp.at(straight_view, ReflectionModel::phong, -1), PreconditionError);
  EXPECT_THROW(lamp.at(straight_view, ReflectionModel::phong, 10001), PreconditionError);
  EXPECT_THROW(exponent_of_highlight(0, 0.5), PreconditionError);
}

TEST(Reflection, BehindABlockerItIsThatOfWhatIsVisible) {
  const ConvexBlocker wall = ConvexPolygon::from_points({{0, -9, 1}, {9, -9, 1}, {9, 9, 1}, {0, 9, 1}});
  const PreparedObstacles obstacles({{wall}, {}});
  const View view{{0, 0, 0}, {0, 0, 1}, {0.5, 0.25, 1}};
  for (const ReflectionModel model : all_models) {
    const Reflection tube = LightReflection(LinearLight{{-1, 0, 2}, {1, 0, 2}}, obstacles).at(view, model, 7);
    const Reflection half =
        LightReflection(LinearLight{{-1, 0, 2}, {0, 0, 2}}, PreparedObstacles({})).at(view, model, 7);
    EXPECT_NEAR(tube.lobe.value, half.lobe.value, tube.lobe.error_bound + half.lobe.error_bound);
    EXPECT_LT(tube.lobe.error_bound, 1e-10);
    const AreaLight whole{ConvexPolygon::from_points({{-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}})};
    const AreaLight seen{ConvexPolygon::from_points({{-1, -1, 2}, {-1, 1, 2}, {0, 1, 2}, {0, -1, 2}})};
    const Reflection lamp = LightReflection(whole, obstacles).at(view, model, 7);
    const Reflection part = LightReflection(seen, PreparedObstacles({})).at(view, model, 7);
    EXPECT_NEAR(lamp.lobe.value, part.lobe.value, lamp.lobe.error_bound + part.lobe.error_bound);
    EXPECT_LT(lamp.lobe.error_bound, 1e-9);
  }
}

}  // namespace
}  // namespace gnomon
