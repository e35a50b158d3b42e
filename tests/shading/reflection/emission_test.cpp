#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "gnomon/irradiance.h"
#include "gnomon/reflection.h"
#include "tests/shading/reflection/definition_oracle.h"
#include "tests/shading/reflection/drawn_views.h"

namespace gnomon {
namespace {

using namespace test_support;

struct ShiningCase {
  LinearLight light;
  View view;
  int exponent = 0;
};

std::string told(const ShiningCase& c) {
  std::ostringstream text;
  text << std::hexfloat;
  for (const Point3& p : {c.light.start, c.light.end, c.view.point, c.view.normal, c.view.to_eye}) {
    text << " {" << p.x << ", " << p.y << ", " << p.z << "}";
  }
  text << std::defaultfloat << " n " << c.exponent << " m " << c.light.emission.exponent << " flaps "
       << c.light.emission.flaps.value_or(90);
  if (c.light.emission.shade) {
    for (const Point3& p : {c.light.emission.shade->from, c.light.emission.shade->to}) {
      text << " {" << p.x << ", " << p.y << ", " << p.z << "}";
    }
  }
  return text.str();
}

Emission drawn_emission(Dice& dice) {
  constexpr std::array powers = {0, 1, 1, 1, 2, 3, 7, 30, 100};
  constexpr std::array angles = {0.001, 10.0, 30.0, 45.0, 60.0, 89.0, 89.999};
  Emission emission{.exponent = dice.one_of(powers)};
  if (dice.once_in(2)) emission.flaps = dice.one_of(angles);
  if (dice.once_in(4)) emission.shade = Shade{drawn_vector(dice), drawn_vector(dice)};
  return emission;
}

ShiningCase drawn_shining_case(Dice& dice) {
  constexpr std::array exponents = {0, 1, 2, 3, 5, 10, 11, 32, 50, 200};
  ShiningCase c;
  c.exponent = dice.one_of(exponents);
  c.light = {added({0, 0, 0}, 3, drawn_vector(dice)), added({0, 0, 0}, 3, drawn_vector(dice)), drawn_emission(dice)};
  if (dice.once_in(4)) c.light.end = added(c.light.start, 1e-3, drawn_vector(dice));
  c.view.point = drawn_vector(dice);
  const Point3 towards = added(c.light.start, -1, c.view.point);
  c.view.normal = added(drawn_vector(dice), dice.draw(0, 2), towards);
  c.view.to_eye =
      dice.once_in(3) ? drawn_vector(dice) : added(mirrored(towards, c.view.normal), 0.3, drawn_vector(dice));
  return c;
}

/// With small integers, so that the wedge's ends, flaps of 45 degrees, the horizon and R's plane pass through ends and
/// the point; next to the light's line, and with lights that are next to nothing or huge.
ShiningCase bent_shining_case(Dice& dice) {
  ShiningCase c = drawn_shining_case(dice);
  const auto draw = [&](int low, int high) {
    const double x = dice.draw(-2, 2), y = dice.draw(-2, 2);
    return Point3{x, y, double(dice.draw(low, high))};
  };
  const Emission emission = c.light.emission;
  c = {{draw(0, 3), draw(1, 3), emission}, {draw(-1, 1), draw(0, 2), draw(0, 2)}, c.exponent};
  if (dice.once_in(2)) c.light.emission.flaps = 45;
  if (dice.once_in(2)) c.light.emission.shade = Shade{draw(-1, 1), draw(-1, 1)};
  const Point3 along = added(c.light.end, -1, c.light.start);
  switch (dice.draw(0, 6)) {
    case 0:
      c.light.end = added(c.light.start, 1e-9, along);
      break;
    case 1:
      c.light.end = added(c.light.start, 1e6, along);
      break;
    case 2:
      c.view.point = added(added(c.light.start, dice.draw(-8, 16) / 8.0, along), 1e-9, drawn_vector(dice));
      break;
    case 3:
      c.light.emission.flaps = std::nextafter(90, 0);
      break;
    default:
      break;
  }
  return c;
}

bool are_parallel(const Point3& a, const Point3& b) {
  return a.y * b.z == a.z * b.y && a.z * b.x == a.x * b.z && a.x * b.y == a.y * b.x;
}

double volume(const Point3& a, const Point3& b, const Point3& c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
}

bool has_sense(const ShiningCase& c) {
  const Point3 along = added(c.light.end, -1, c.light.start);
  if (along == Point3{} || c.view.normal == Point3{} || c.view.to_eye == Point3{}) return false;
  if (are_parallel(added(c.light.start, -1, c.view.point), along)) return false;
  if (product(c.view.normal, c.view.to_eye) <= 0) return false;
  // In the horizon the quadrature sees rounding: of a light there nothing is received, as a test of its own has it.
  const auto is_in_horizon = [&](const Point3& end) {
    return std::fabs(product(c.view.normal, added(end, -1, c.view.point))) < 1e-12;
  };
  if (is_in_horizon(c.light.start) && is_in_horizon(c.light.end)) return false;
  if (!c.light.emission.shade) return true;
  // Directions along the light, and a wedge of no angle, are refused by scenes.
  const auto& [from, to] = *c.light.emission.shade;
  return !are_parallel(from, along) && !are_parallel(to, along) && std::fabs(volume(along, from, to)) > 1e-9;
}

/// Whether the point lies on an end of the wedge, exactly, where no oracle in numbers decides.
bool is_on_the_wedges_end(const ShiningCase& c) {
  if (!c.light.emission.shade) return false;
  const Point3 along = added(c.light.end, -1, c.light.start), x = added(c.view.point, -1, c.light.start);
  const auto& [from, to] = *c.light.emission.shade;
  const double size = std::sqrt(product(along, along)) * 1e-12;
  return std::fabs(volume(along, from, x)) < size || std::fabs(volume(along, to, x)) < size;
}

struct ShiningTally {
  int tried = 0, positive = 0, unsure = 0;
};

void expect_within_bound(const ShiningCase& c, ReflectionModel model, ShiningTally& tally) {
  const Integrated<Long> exact = integrated_line(c.light, c.view, model, c.exponent);
  if (!exact.is_certain) {
    ++tally.unsure;
    return;
  }
  const Reflection r = LightReflection(c.light, PreparedObstacles({})).at(c.view, model, c.exponent);
  const Long slack = 1e-22 * exact.across;
  ++tally.tried;
  tally.positive += exact.lobe > 1e-9 * exact.across;
  ASSERT_LE(abs(exact.received - r.received.value), r.received.error_bound + slack)
      << told(c) << ": " << r.received.value << " for " << exact.received << " of " << exact.across;
  ASSERT_LE(abs(exact.lobe - r.lobe.value), r.lobe.error_bound + slack)
      << told(c) << " model " << static_cast<int>(model) << ": " << r.lobe.value << " for " << exact.lobe;
  ASSERT_LE(r.received.error_bound, 1.01e-9 * exact.across) << told(c);
  ASSERT_LE(r.lobe.error_bound, 1.01e-9 * exact.across) << told(c) << " model " << static_cast<int>(model);
  const Irradiance e = light_irradiance(c.light, 1, {}, c.view.point, c.view.normal);
  ASSERT_LE(abs(exact.received - e.value), e.error_bound + slack) << told(c);
}

class EmissionAgreement : public ::testing::TestWithParam<ReflectionModel> {
 protected:
  ShiningTally compare(std::uint32_t seed, int count, ShiningCase (*draw)(Dice&)) {
    Dice dice(seed);
    ShiningTally tally;
    while (tally.tried < (GNOMON_LONG ? 20 : 1) * count && !HasFatalFailure()) {
      const ShiningCase c = draw(dice);
      if (has_sense(c) && !is_on_the_wedges_end(c)) expect_within_bound(c, GetParam(), tally);
    }
    EXPECT_LE(tally.unsure, tally.tried / 50);
    return tally;
  }
};

TEST_P(EmissionAgreement, BoundsHoldTheIntegralOfTheDefinition) {
  EXPECT_GT(compare(61, 500, drawn_shining_case).positive, 150);
}

TEST_P(EmissionAgreement, BoundsHoldWhereFlapsWedgeHorizonAndEyeAreInSpecialPosition) {
  EXPECT_GT(compare(62, 500, bent_shining_case).positive, 100);
}

INSTANTIATE_TEST_SUITE_P(Models, EmissionAgreement, ::testing::ValuesIn(all_models));

const View up{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};

double received(const LinearLight& light, const View& view = up) {
  return LightReflection(light, PreparedObstacles({})).at(view, ReflectionModel::phong, 1).received.value;
}

TEST(Emission, OfAThinTubeIsThatOfALambertianCylinder) {
  // Above the middle of a tube of length 2 l at height h: k (l h / (l² + h²) + atan(l / h)) / h.
  const double l = 1.5, h = 2, exact = (l * h / (l * l + h * h) + std::atan(l / h)) / h;
  EXPECT_NEAR(received({{-l, 0, h}, {l, 0, h}, {.exponent = 1}}), exact, 1e-15);
}

TEST(Emission, BetweenFlapsIsThatOfAShorterLight) {
  const double reach = 2 * std::tan(std::numbers::pi / 6);
  EXPECT_NEAR(received({{-9, 0, 2}, {9, 0, 2}, {.flaps = 30}}), received({{-reach, 0, 2}, {reach, 0, 2}}), 1e-15);
  EXPECT_EQ(received({{3, 0, 2}, {9, 0, 2}, {.flaps = 30}}), 0);
}

TEST(Emission, OfAWedgeIncludesItsEndsAndNothingBeyond) {
  const LinearLight right{{-1, 0, 2}, {1, 0, 2}, {.shade = Shade{{0, -1, -1}, {0, 0, -1}}}};
  const auto at = [&](double y) { return received(right, {{0, y, 0}, {0, 0, 1}, {0, 0, 1}}); };
  const auto all = [&](double y) { return received({right.start, right.end}, {{0, y, 0}, {0, 0, 1}, {0, 0, 1}}); };
  EXPECT_EQ(at(0), all(0)) << "straight below";
  EXPECT_EQ(at(-2), all(-2)) << "on the other end";
  EXPECT_EQ(at(0x1p-60), 0);
  EXPECT_EQ(at(std::nextafter(-2.0, -3)), 0);
  const LinearLight rest{right.start, right.end, {.shade = Shade{{0, 0, -1}, {0, -1, -1}}}};
  EXPECT_EQ(received(rest), all(0));
  EXPECT_EQ(received(rest, {{0, -1, 0}, {0, 0, 1}, {0, 0, 1}}), 0);
  EXPECT_EQ(received(rest, {{0, -3, 0}, {0, 0, 1}, {0, 0, 1}}), all(-3));
}

TEST(EmissionDegenerate, InTheHorizonNothingIsReceived) {
  const LinearLight low{{1, -1, 0}, {1, 2, 0}, {.exponent = 1, .flaps = 45}};
  for (const ReflectionModel model : all_models) {
    const Reflection r = LightReflection(low, PreparedObstacles({})).at(up, model, 3);
    EXPECT_EQ(r.received.value + r.received.error_bound + r.lobe.value + r.lobe.error_bound, 0);
  }
}

TEST(EmissionDegenerate, OnTheLightsLineOnlyWhatShinesAlikeEverywhereIsSeen) {
  const View on_line{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  const Point3 near{0, 0, 1}, far{0, 0, 2};
  EXPECT_EQ(received({near, far}, on_line), 0.5);
  EXPECT_EQ(received({near, far, {.exponent = 1}}, on_line), 0);
  EXPECT_EQ(received({near, far, {.flaps = 89}}, on_line), 0);
  EXPECT_EQ(received({near, far, {.shade = Shade{{1, 0, 0}, {0, 1, 0}}}}, on_line), 0.5);
  EXPECT_TRUE(std::isinf(received({{0, 0, 0}, far, {.exponent = 1}}, on_line)));
}

}  // namespace
}  // namespace gnomon
