#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "gnomon/reflection.h"
#include "tests/shading/reflection/definition_oracle.h"
#include "tests/shading/reflection/drawn_views.h"

namespace gnomon {
namespace {

using namespace test_support;

struct Case {
  LinearLight light;
  View view;
  int exponent = 0;
};

std::string told(const Case& c) {
  std::ostringstream text;
  text << std::hexfloat;
  for (const Point3& p : {c.light.start, c.light.end, c.view.point, c.view.normal, c.view.to_eye}) {
    text << " {" << p.x << ", " << p.y << ", " << p.z << "}";
  }
  text << ' ' << c.exponent;
  return text.str();
}

/// A surface somewhere, whose eye often sees the light mirrored.
Case drawn_case(Dice& dice) {
  constexpr std::array exponents = {0, 1, 2, 3, 5, 10, 11, 32, 50, 64, 199, 200, 1000};
  Case c;
  c.exponent = dice.one_of(exponents);
  c.light = {added({0, 0, 0}, 3, drawn_vector(dice)), added({0, 0, 0}, 3, drawn_vector(dice))};
  if (dice.once_in(3)) c.light.end = added(c.light.start, 1e-3, drawn_vector(dice));
  c.view.point = drawn_vector(dice);
  const Point3 towards = added(c.light.start, -1, c.view.point);
  c.view.normal = added(drawn_vector(dice), dice.draw(0, 2), towards);
  c.view.to_eye =
      dice.once_in(3) ? drawn_vector(dice) : added(mirrored(towards, c.view.normal), 0.3, drawn_vector(dice));
  return c;
}

/// The peak that bounds are measured by: the integral without lobe and cosine, but not much more than a lobe is wide.
void expect_within_bound(const Case& c, ReflectionModel model, int* outside, double widest) {
  const Integrated<Long> exact = test_support::integrated_line(c.light, c.view, model, c.exponent);
  ASSERT_TRUE(exact.is_certain) << told(c);
  const Reflection r = LightReflection(c.light, PreparedObstacles({})).at(c.view, model, c.exponent);
  if (product(c.view.normal, c.view.to_eye) <= 0) return;
  const Long slack = 1e-22 * exact.across;
  *outside += abs(exact.received - r.received.value) > r.received.error_bound + slack;
  *outside += abs(exact.lobe - r.lobe.value) > r.lobe.error_bound + slack;
  EXPECT_EQ(*outside, 0) << told(c) << " model " << static_cast<int>(model) << ": " << r.received.value << " +- "
                         << r.received.error_bound << " for " << exact.received << ", " << r.lobe.value << " +- "
                         << r.lobe.error_bound << " for " << exact.lobe << " of " << exact.across;
  ASSERT_EQ(*outside, 0);
  ASSERT_LE(r.received.error_bound, widest * exact.across) << told(c);
  ASSERT_LE(r.lobe.error_bound, widest * exact.across) << told(c) << " model " << static_cast<int>(model);
}

class LinearReflectionAgreement : public ::testing::TestWithParam<ReflectionModel> {};

TEST_P(LinearReflectionAgreement, BoundsHoldTheIntegralOfTheDefinition) {
  Dice dice(23);
  int outside = 0;
  for (int round = 0; round < (GNOMON_LONG ? 10000 : 500); ++round) {
    expect_within_bound(drawn_case(dice), GetParam(), &outside, 1.01e-9);
    if (HasFatalFailure()) return;
  }
}

/// With small integers, so that light, horizon and R's plane meet in ends, and with what is next to nothing or huge.
Case integer_case(Dice& dice) {
  const auto draw = [&](int low, int high) {
    const double x = dice.draw(-3, 3), y = dice.draw(-3, 3);
    return Point3{x, y, double(dice.draw(low, high))};
  };
  constexpr std::array exponents = {0, 1, 2, 3, 7, 10, 50, 10000};
  Case c{{draw(-1, 4), draw(0, 4)}, {draw(-1, 1), draw(0, 2), draw(0, 2)}, dice.one_of(exponents)};
  if (dice.once_in(3)) c.view.normal = {0, 0, 1};
  return c;
}

/// A few units in the last place off the light's line, beside it or beyond its ends.
void move_to_line(Case& c, Dice& dice) {
  const Point3 along = added(c.light.end, -1, c.light.start);
  const double share = dice.draw(-16, 24) / 8.0 + 1e-3;
  c.view.point = added(c.light.start, share, along);
  c.view.point.x += dice.draw(1, 3) * std::fmax(std::fabs(c.view.point.x), 0x1p-6) * 0x1p-52;
}

/// The eye in the light's direction's opposite, just above the horizon while the light is.
void look_against(Case& c, Dice& dice) {
  const double low = std::pow(10.0, -dice.draw(1, 9));
  c.light = {{3, -1 + low * dice.draw(0, 2), low * dice.draw(0, 2)}, {3, 1, 1}};
  c.view = {{0, 0, 0}, {0, 0, 1}, {-3, low * dice.draw(-1, 1), low}};
}

Case bent_case(Dice& dice) {
  Case c = dice.once_in(2) ? integer_case(dice) : drawn_case(dice);
  const Point3 along = added(c.light.end, -1, c.light.start);
  switch (dice.draw(0, 9)) {
    case 0:
      c.light.end = added(c.light.start, 1e-9, along);
      break;
    case 1:
      c.light.end = added(c.light.start, 1e9, along);
      break;
    case 2:
      move_to_line(c, dice);
      break;
    case 3:
      c.view.point = added(c.light.start, 1e-12, drawn_vector(dice));
      break;
    case 4:
      look_against(c, dice);
      break;
    case 5:
      c.view.to_eye = mirrored(added(c.light.start, -1, c.view.point), c.view.normal);
      break;
    case 6:
      c.view.to_eye = {-c.view.normal.y, c.view.normal.x, 1e-9};
      break;
    default:
      break;
  }
  return c;
}

bool has_sense(const Case& c) {
  const auto cross_is_zero = [](const Point3& a, const Point3& b) {
    return a.y * b.z == a.z * b.y && a.z * b.x == a.x * b.z && a.x * b.y == a.y * b.x;
  };
  const bool is_on_line = cross_is_zero(added(c.light.start, -1, c.view.point), added(c.light.end, -1, c.light.start));
  return !(c.light.start == c.light.end) && !(c.view.normal == Point3{}) && !(c.view.to_eye == Point3{}) && !is_on_line;
}

TEST_P(LinearReflectionAgreement, BoundsHoldWhereLightHorizonAndEyeAreInSpecialPosition) {
  Dice dice(24);
  int outside = 0;
  for (int round = 0; round < (GNOMON_LONG ? 10000 : 500);) {
    const Case c = bent_case(dice);
    if (!has_sense(c)) continue;
    ++round;
    expect_within_bound(c, GetParam(), &outside, 1.01e-9);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, LinearReflectionAgreement, ::testing::ValuesIn(all_models));

}  // namespace
}  // namespace gnomon
