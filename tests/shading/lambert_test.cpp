#include "shading/lambert.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "gnomon/errors.h"
#include "shading/reference_irradiance.h"
#include "tests/geometry/visibility/splitting_oracle.h"

namespace gnomon {
namespace {

AreaLight square_light(double half, double height) {
  return {ConvexPolygon::from_points(
      {{-half, -half, height}, {-half, half, height}, {half, half, height}, {half, -half, height}})};
}

std::vector<ExactView> views_from(const Point3& p, const test_support::SplitView& split) {
  std::vector<ExactView> views;
  for (const auto& piece : split.visible) {
    ExactView& view = views.emplace_back();
    for (const laws::ExactVector& v : piece) {
      view.push_back({Rational(v.x - Rational(p.x)), Rational(v.y - Rational(p.y)), Rational(v.z - Rational(p.z))});
    }
  }
  return views;
}

/// The fast irradiance and the interval of 200 bits around the exact one.
struct Compared {
  Irradiance fast;
  IrradianceInterval truth;

  bool within_bound() const {
    return fast.value - fast.error_bound <= truth.high && truth.low <= fast.value + fast.error_bound;
  }
};

Compared compare(const AreaLight& light, const std::vector<ConvexBlocker>& blockers, const Point3& p, const Point3& n) {
  FastVisibility visibility(light, BlockerSet(blockers));
  const std::optional<VisibleAreaLight> seen = visibility.visible_from(p);
  if (!seen) return {};
  const test_support::SplitView split = test_support::split_view(light, blockers, p);
  const IrradianceInterval truth =
      reference_irradiance(views_from(p, split), {Rational(n.x), Rational(n.y), Rational(n.z)}, 200);
  return {lambert_irradiance(*seen, n, 1), truth};
}

class LambertAgreement : public ::testing::TestWithParam<int> {};

/// Receivers in every direction: above, across and below their horizons, with small integers so that edges lie in it.
TEST_P(LambertAgreement, BoundHoldsTheTruthOf200Bits) {
  std::mt19937 engine(static_cast<unsigned>(GetParam()));
  const auto draw = [&](int least, int most) {
    return least + static_cast<int>(engine() % static_cast<unsigned>(most - least + 1));
  };
  const auto point = [&](int low, int high) {
    const double x = draw(-3, 3);
    const double y = draw(-3, 3);
    return Point3{x, y, static_cast<double>(draw(low, high))};
  };
  for (int round = 0; round < 300; ++round) {
    std::vector<ConvexBlocker> blockers;
    while (static_cast<int>(blockers.size()) < GetParam()) {
      const std::vector<Point3> triangle = {point(1, 6), point(1, 6), point(1, 6)};
      if (!ConvexPolygon::defect(triangle)) blockers.push_back(ConvexPolygon::from_points(triangle));
    }
    const double scale = draw(0, 1) == 0 ? 1 : 1.0 / 7;
    const Point3 p{scale * draw(-5, 5), scale * draw(-5, 5), scale * draw(-5, 0) + draw(0, 1) * 7.5};
    const Point3 n{double(draw(-2, 2)), double(draw(-2, 2)), draw(-4, 4) + 0.5 * draw(0, 1)};
    if (n == Point3{}) continue;
    const Compared compared = compare(square_light(2, 8), blockers, p, n);
    ASSERT_TRUE(compared.within_bound()) << round << ": " << compared.fast.value << " +- " << compared.fast.error_bound
                                         << " is not in " << compared.truth.low << ", " << compared.truth.high;
    ASSERT_LE(compared.fast.error_bound, p.z <= 0 ? 1e-11 : 4) << round;
  }
}

INSTANTIATE_TEST_SUITE_P(Blockers, LambertAgreement, ::testing::Values(0, 1, 3, 8));

Point3 scaled(const Point3& p, int exponent) {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
}

/// A light, triangles before it, and a point that sees it across or above its horizon.
struct Room {
  std::vector<Point3> light;
  std::vector<std::vector<Point3>> triangles;
  Point3 p;
  Point3 normal;

  /// With all lengths times a power of two.
  Irradiance irradiance(int exponent) const {
    const auto polygon = [exponent](std::vector<Point3> points) {
      for (Point3& point : points) point = scaled(point, exponent);
      return ConvexPolygon::from_points(std::move(points));
    };
    std::vector<ConvexBlocker> blockers;
    for (const auto& triangle : triangles) blockers.emplace_back(polygon(triangle));
    FastVisibility visibility({polygon(light)}, BlockerSet(blockers));
    return lambert_irradiance(visibility.visible_from(scaled(p, exponent)).value(), normal, 1);
  }
};

Room drawn_room(std::mt19937& engine) {
  const auto draw = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
  };
  const auto point = [&](double low, double high) {
    const double x = draw(-1, 1);
    const double y = draw(-1, 1);
    return Point3{x, y, draw(low, high)};
  };
  Room room;
  room.light = {{-.5, -.5, 4}, {-.5, .5, 4}, {.5, .5, 4}, {.5, -.5, 4}};
  for (unsigned count = engine() % 4; count > 0; --count)
    room.triangles.push_back({point(1, 3), point(1, 3), point(1, 3)});
  room.p = point(-1, 0.5);
  room.normal = point(-0.5, 1);
  return room;
}

TEST(Lambert, LengthsOfAnyPowerOfTwoGiveTheSameWithinTheBounds) {
  std::mt19937 engine(1);
  for (int round = 0; round < 300; ++round) {
    const Room room = drawn_room(engine);
    const Irradiance plain = room.irradiance(0);
    for (const int exponent : {-900, -300, -100, -60, -40, -20, 20, 40, 60, 80, 97}) {
      const Irradiance other = room.irradiance(exponent);
      ASSERT_LE(std::fabs(plain.value - other.value), plain.error_bound + other.error_bound)
          << round << " " << exponent;
      ASSERT_TRUE(exponent < -60 || other.error_bound <= 1e-10) << round << " " << exponent << " " << other.error_bound;
    }
  }
}

TEST(Lambert, AHugeLightGivesPiTimesItsRadiance) {
  FastVisibility visibility(square_light(1e9, 1), BlockerSet({}));
  const Irradiance e = lambert_irradiance(*visibility.visible_from({0, 0, 0}), {0, 0, 3}, 2);
  EXPECT_NEAR(e.value, 2 * std::numbers::pi, 1e-8);
}

TEST(Lambert, ALightBelowTheHorizonGivesExactlyNothing) {
  FastVisibility visibility(square_light(1, 4), BlockerSet({}));
  const Irradiance e = lambert_irradiance(*visibility.visible_from({0, 0, 0}), {0, 0, -1}, 1);
  EXPECT_EQ(e.value, 0);
  EXPECT_EQ(e.error_bound, 0);
}

TEST(Lambert, ANormalWithoutDirectionIsRefused) {
  FastVisibility visibility(square_light(1, 4), BlockerSet({}));
  const std::optional<VisibleAreaLight> seen = visibility.visible_from({0, 0, 0});
  EXPECT_THROW(lambert_irradiance(*seen, {0, 0, 0}, 1), PreconditionError);
}

}  // namespace
}  // namespace gnomon
