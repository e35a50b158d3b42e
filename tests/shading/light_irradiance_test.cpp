#include "gnomon/irradiance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "geometry/visibility/visible_part.h"
#include "gnomon/errors.h"
#include "shading/reference_irradiance.h"
#include "shading/small_lights.h"
#include "tests/geometry/visibility/splitting_oracle.h"
#include "tests/support/dice.h"

namespace gnomon {
namespace {

using test_support::Dice;

Point3 draw_point(Dice& dice, int reach, int low, int high) {
  const double x = dice.draw(-reach, reach);
  const double y = dice.draw(-reach, reach);
  return {x, y, static_cast<double>(dice.draw(low, high))};
}

std::vector<ConvexBlocker> draw_triangles(Dice& dice, std::size_t count, int high) {
  std::vector<ConvexBlocker> blockers;
  while (blockers.size() < count) {
    const std::vector<Point3> triangle = {draw_point(dice, 3, 1, high), draw_point(dice, 3, 1, high),
                                          draw_point(dice, 3, 1, high)};
    if (!ConvexPolygon::defect(triangle)) blockers.push_back(ConvexPolygon::from_points(triangle));
  }
  return blockers;
}

/// The integral of cosine over squared distance from its definition: the trapezium rule after x = tanh(sinh t), which
/// forgives a kink at an end.
long double integral(const Point3& a, const Point3& b, const Point3& p, const Point3& n, long double s0,
                     long double s1) {
  const long double half = (s1 - s0) / 2;
  const long double d[3] = {(long double)b.x - a.x, (long double)b.y - a.y, (long double)b.z - a.z};
  const long double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  const long double norm = std::sqrt((long double)n.x * n.x + (long double)n.y * n.y + (long double)n.z * n.z);
  long double sum = 0;
  const long double step = 1.0L / 64;
  for (int k = -256; k <= 256; ++k) {
    const long double t = k * step;
    const long double u = std::sinh(t) * 1.5707963267948966192L;
    const long double weight = 1.5707963267948966192L * std::cosh(t) / (std::cosh(u) * std::cosh(u));
    const long double s = s0 + half * (1 + std::tanh(u));
    const long double v[3] = {a.x + s * d[0] - p.x, a.y + s * d[1] - p.y, a.z + s * d[2] - p.z};
    const long double r = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    sum += weight * std::fmax(v[0] * n.x + v[1] * n.y + v[2] * n.z, 0.0L) / (norm * r * r * r);
  }
  return sum * step * half * length;
}

/// Where the horizon crosses the light, or 1.
long double horizon_share(const Point3& a, const Point3& b, const Point3& p, const Point3& n) {
  const long double from = (a.x - p.x) * n.x + (a.y - p.y) * n.y + (a.z - p.z) * n.z;
  const long double to = (b.x - p.x) * n.x + (b.y - p.y) * n.y + (b.z - p.z) * n.z;
  return from * to < 0 ? from / (from - to) : 1;
}

TEST(LightIrradianceAgreement, LinearLightsMatchTheIntegralOfTheDefinition) {
  Dice dice(7);
  for (int round = 0; round < 400; ++round) {
    const Point3 a = draw_point(dice, 3, 4, 7);
    const Point3 b = draw_point(dice, 3, 4, 7);
    const Point3 p = draw_point(dice, 4, -2, 3);
    const Point3 n = draw_point(dice, 2, -2, 2);
    if (a == b || n == Point3{}) continue;
    LightIrradiance light(LinearLight{a, b}, 2, PreparedObstacles({}));
    const Irradiance e = light.at(p, n);
    const long double cut = horizon_share(a, b, p, n);
    const long double expected = 2 * (integral(a, b, p, n, 0, cut) + integral(a, b, p, n, cut, 1));
    ASSERT_LE(std::fabs(e.value - expected), e.error_bound + 1e-15L * (1 + expected)) << round;
    ASSERT_LE(e.error_bound, 1e-12) << round;
  }
}

TEST(LightIrradiance, AnOpaqueHalfHidesHalfOfALinearLight) {
  const ConvexBlocker wall = ConvexPolygon::from_points({{0, -9, 1}, {9, -9, 1}, {9, 9, 1}, {0, 9, 1}});
  const PreparedObstacles obstacles({{wall}, {}});
  LightIrradiance bare(LinearLight{{-1, 0, 2}, {1, 0, 2}}, 1, PreparedObstacles({}));
  LightIrradiance hidden(LinearLight{{-1, 0, 2}, {1, 0, 2}}, 1, obstacles);
  EXPECT_NEAR(hidden.at({0, 0, 0}, {0, 0, 1}).value, bare.at({0, 0, 0}, {0, 0, 1}).value / 2, 1e-15);
}

TEST(LightIrradiance, OfALinearLightSeenEndOnIsTheDifferenceOfInverseDistances) {
  LightIrradiance light(LinearLight{{0, 0, 2}, {0, 0, 4}}, 1, PreparedObstacles({}));
  EXPECT_NEAR(light.at({0, 0, 0}, {0, 0, 1}).value, 0.25, 1e-15);
  EXPECT_EQ(light.at({0, 0, 3}, {0, 0, 1}).value, HUGE_VAL);
}

TEST(LightIrradiance, OfPointsAndDirectionsIsTheCosineLaw) {
  LightIrradiance bulb(PointLight{{0, 3, 4}}, 50, PreparedObstacles({}));
  const Irradiance e = bulb.at({0, 0, 0}, {0, 0, 2});
  EXPECT_NEAR(e.value, 50 * 0.8 / 25, e.error_bound);
  EXPECT_LT(e.error_bound, 1e-14);
  LightIrradiance sun(DirectionalLight{{0, -3, -4}}, 10, PreparedObstacles({}));
  EXPECT_NEAR(sun.at({0, 0, 0}, {0, 0, 1}).value, 8, 1e-14);
  EXPECT_EQ(sun.at({0, 0, 0}, {0, 0, -1}).value, 0);
}

TEST(LightIrradiance, ANormalWithoutDirectionIsRefused) {
  LightIrradiance bulb(PointLight{{0, 3, 4}}, 50, PreparedObstacles({}));
  EXPECT_THROW(bulb.at({0, 0, 0}, {0, 0, 0}), PreconditionError);
}

/// What the exact level says of the light before the receiver, interval by interval.
Irradiance exact_irradiance(const LinearLight& light, const std::vector<ConvexBlocker>& blockers, const Point3& p,
                            const Point3& n) {
  return linear_irradiance(
      light, exact_visible_part(light, {blockers, {}}, ReceiverPoint{p, FacingNormal{n}}).intervals, p, n);
}

TEST(LightIrradianceAgreement, LinearLightsBehindBlockersMatchTheExactLevel) {
  Dice dice(11);
  int unlike = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::vector<ConvexBlocker> blockers = draw_triangles(dice, 4, 6);
    const LinearLight tube{draw_point(dice, 3, 5, 7), draw_point(dice, 3, 6, 8)};
    const Point3 p = draw_point(dice, 4, -2, 8);
    const Point3 n = draw_point(dice, 2, -2, 2);
    if (tube.start == tube.end || n == Point3{}) continue;
    const Irradiance exact = exact_irradiance(tube, blockers, p, n);
    const Irradiance e = LightIrradiance(tube, 1, PreparedObstacles({blockers, {}})).at(p, n);
    if (exact.value == HUGE_VAL) continue;
    ASSERT_LE(std::fabs(e.value - exact.value), e.error_bound + exact.error_bound) << round;
    ASSERT_LE(e.error_bound, 1e-6) << round;
    unlike += e.value != exact.value ? 1 : 0;
  }
  EXPECT_GT(unlike, 300) << "the fast level has answered, not the exact one";
}

/// Blockers that cross the light's plane, so that both levels answer.
TEST(LightIrradianceAgreement, BothLevelsHoldTheTruthOf200Bits) {
  Dice dice(3);
  for (int round = 0; round < 500; ++round) {
    const std::vector<ConvexBlocker> blockers = draw_triangles(dice, 4, 10);
    const AreaLight light{ConvexPolygon::from_points({{-2, -2, 8}, {-2, 2, 8}, {2, 2, 8}, {2, -2, 8}}), round % 2 == 0};
    const Point3 p = draw_point(dice, 4, -1, 10);
    const Point3 n = draw_point(dice, 2, -3, 3);
    if (n == Point3{}) continue;
    std::vector<std::vector<ExactCorner>> views;
    for (const auto& piece : test_support::split_view(light, blockers, p).visible) {
      auto& view = views.emplace_back();
      for (const auto& v : piece) {
        view.push_back({Rational(v.x - Rational(p.x)), Rational(v.y - Rational(p.y)), Rational(v.z - Rational(p.z))});
      }
    }
    const IrradianceInterval truth = reference_irradiance(views, {Rational(n.x), Rational(n.y), Rational(n.z)}, 200);
    const Irradiance e = LightIrradiance(light, 1, PreparedObstacles({blockers, {}})).at(p, n);
    ASSERT_LE(e.value - e.error_bound, truth.high) << round;
    ASSERT_GE(e.value + e.error_bound, truth.low) << round;
    ASSERT_LE(e.error_bound, 1e-6) << round;
  }
}

/// A light behind a triangle, a point and its normal, drawn from a seed; all lengths times a power of two.
Irradiance of_size(std::size_t kind, unsigned seed, int exponent) {
  Dice dice(seed);
  const auto point = [&](int low, int high) {
    const Point3 p = draw_point(dice, 3, low, high);
    return Point3{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  };
  const std::vector<Point3> corners = {point(2, 4), point(2, 4), point(2, 4)};
  const Light lights[] = {PointLight{point(6, 8)}, LinearLight{point(5, 6), point(7, 8)},
                          AreaLight{ConvexPolygon::from_points({point(5, 5), point(6, 6), point(7, 7)}), true},
                          DirectionalLight{point(-4, -2)}};
  std::vector<ConvexBlocker> blockers;
  if (!ConvexPolygon::defect(corners)) blockers.emplace_back(ConvexPolygon::from_points(corners));
  LightIrradiance light(lights[kind], 1, PreparedObstacles({blockers, {}}));
  const Point3 p = point(-1, 1);
  return light.at(p, draw_point(dice, 2, 1, 3));
}

TEST(LightIrradiance, LengthsOfAnyPowerOfTwoGiveTheSameTimesThatPowerOfDistance) {
  constexpr int falls[] = {2, 1, 0, 0};  // of a point, a line, an area, a direction
  for (std::size_t kind = 0; kind < 4; ++kind) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
      const Irradiance plain = of_size(kind, seed, 0);
      for (const int exponent : {-400, -262, -131, -60, 60, 97, 131, 262, 400}) {
        const Irradiance other = of_size(kind, seed, exponent);
        const double value = std::ldexp(other.value, falls[kind] * exponent);
        const double bound = std::ldexp(other.error_bound, falls[kind] * exponent);
        ASSERT_LE(std::fabs(value - plain.value), bound + plain.error_bound) << kind << " " << seed << " " << exponent;
        ASSERT_LE(bound, 1e-9) << kind << " " << seed << " " << exponent;
      }
    }
  }
}

TEST(LightIrradianceRegression, NextToTheLineOfALinearLightBoundsAreNotNegative) {
  for (const double y : {1e-12, 1e-15, 3e-16, 1e-17, 1e-20}) {
    LightIrradiance light(LinearLight{{1, y, 0}, {2, y, 0}}, 1, PreparedObstacles({}));
    const Irradiance e = light.at({0, 0, 0}, {0, 1, 0});
    ASSERT_GE(e.error_bound, 0) << y;
    EXPECT_NEAR(e.value, y * (0.5 - 0.125), e.error_bound) << y;
  }
}

TEST(LightIrradianceRegression, AnEndMuchNearerThanTheOtherKeepsItsDigits) {
  for (const double near : {1e-150, 1e-158, 1e-160, 1e-161}) {
    LightIrradiance end_on(LinearLight{{near, 0, 0}, {1, 0, 0}}, 1, PreparedObstacles({}));
    const Irradiance e = end_on.at({0, 0, 0}, {1, 0, 0});
    EXPECT_LE(e.error_bound, 1e-12 * e.value) << near;
    EXPECT_NEAR(e.value * near, 1, e.error_bound * near + 1e-15) << near;
    LightIrradiance across(LinearLight{{near, near / 2, 0}, {1, near / 2, 0}}, 1, PreparedObstacles({}));
    const Irradiance f = across.at({0, 0, 0}, {1, 0, 0});
    EXPECT_LE(f.error_bound, 1e-12 * f.value) << near;
    EXPECT_NEAR(f.value * near, 1 / std::sqrt(1.25), f.error_bound * near + 1e-15) << near;
  }
}

/// In 256 bits, of what an area light shows without blockers.
double true_irradiance(const AreaLight& light, const Point3& p, const Point3& normal) {
  std::vector<ExactView> views;
  for (const VisibleFacet& facet : exact_visible_part(light, {}, p).facets) {
    for (const ExactPolygon& polygon : facet.visible) {
      ExactView& view = views.emplace_back();
      for (const ExactVector& corner : polygon) {
        const ExactVector d = corner - exact(p);
        view.push_back({d.x, d.y, d.z});
      }
    }
  }
  return reference_irradiance(views, {Rational(normal.x), Rational(normal.y), Rational(normal.z)}, 256).low;
}

TEST(LightIrradianceRegression, NextToAnEdgeOfALightTheHorizonCutsInTheRightPlace) {
  struct Case {
    std::vector<Point3> light;
    Point3 p;
    Point3 normal;
  };
  const Case cases[] = {
      {{{-3, 5, 1}, {-1, 6, -6}, {-4, -3, -4}}, {-0x1.fffffffffffffp+0, 5.5, -2.5}, {1, -3, -1}},
      {{{6, 6, -6}, {4, -3, 3}, {-6, -9, 8}, {-4, 0, -1}}, {0x1.4000000000001p+2, 1.5, -1.5}, {-1, -5, -1}},
      {{{0, -3, 3}, {-2, -5, 5}, {1, -1, 4}, {3, 1, 2}}, {-0x1.fffffffffffffp-1, -4, 4}, {1, 3, 4}},
      {{{0, -1.5, 1.5}, {-1, -1.25, 1.25}, {1, -1, 4}}, {-0x1.fffffffffffffp-2, -1.375, 1.375}, {1, 1.5, 4}},
      {{{-3, -4, -5}, {1, -3, 3}, {0, -1, 9}, {-4, -2, 1}}, {1, -2, 2}, {2, 3, -4}},
  };
  for (const Case& c : cases) {
    const AreaLight light{ConvexPolygon::from_points(c.light), true};
    LightIrradiance irradiance(light, 1, PreparedObstacles({}));
    const Irradiance e = irradiance.at(c.p, c.normal);
    EXPECT_NEAR(e.value, true_irradiance(light, c.p, c.normal), e.error_bound + 1e-15) << c.p.x;
    EXPECT_LE(e.error_bound, 1e-9) << c.p.x;
  }
}

/// Thin triangles, seen from beside their sides.
TEST(LightIrradianceAgreement, BesideTheSidesOfThinLightsBoundsHoldTheTruth) {
  std::mt19937 engine(7);
  const auto draw = [&] { return 2.0 * static_cast<double>(engine()) / 4294967296.0 - 1; };
  for (int round = 0; round < 400; ++round) {
    const Point3 a{draw(), draw(), draw()};
    const Point3 b{draw(), draw(), draw()};
    const double width = std::ldexp(1.0, -static_cast<int>(engine() % 40));
    const Point3 c{(a.x + b.x) / 2 + width * draw(), (a.y + b.y) / 2 + width * draw(),
                   (a.z + b.z) / 2 + width * draw()};
    const std::vector<Point3> corners = {a, b, c};
    if (ConvexPolygon::defect(corners)) continue;
    const double t = (draw() + 1) / 2;
    const double away = std::ldexp(1.0, -static_cast<int>(engine() % 52));
    const Point3 p{a.x + t * (b.x - a.x) + away * draw(), a.y + t * (b.y - a.y) + away * draw(),
                   a.z + t * (b.z - a.z) + away * draw()};
    const Point3 normal{draw(), draw(), draw()};
    const AreaLight light{ConvexPolygon::from_points(corners), true};
    LightIrradiance irradiance(light, 1, PreparedObstacles({}));
    const Irradiance e = irradiance.at(p, normal);
    ASSERT_NEAR(e.value, true_irradiance(light, p, normal), e.error_bound) << round;
  }
}

TEST(LightIrradianceRegression, ALightWhoseNormalUnderflowsIsCutAtTheHorizonAsAnyOther) {
  for (const int size : {-1000, -600, 0, 400}) {
    const auto scaled = [&](double x, double y, double z) {
      return Point3{std::ldexp(x, size), std::ldexp(y, size), std::ldexp(z, size)};
    };
    const AreaLight light{
        ConvexPolygon::from_points({scaled(-3, -4, -5), scaled(1, -3, 3), scaled(0, -1, 9), scaled(-4, -2, 1)}), true};
    LightIrradiance irradiance(light, 1, PreparedObstacles({}));
    const Irradiance e = irradiance.at(scaled(1, -2, 2), {2, 3, -4});
    EXPECT_NEAR(e.value, 0.0097019449378414613, e.error_bound) << size;
    EXPECT_LE(e.error_bound, 1e-9) << size;
  }
}

/// Nearly all around the point, which turns away from it.
TEST(LightIrradianceRegression, ALightAllAroundIsLiftedRightWhereItsNormalUnderflows) {
  const auto irradiance = [](int size) {
    std::vector<Point3> corners;
    for (const auto& [x, y] :
         {std::pair{10, 4}, {10, -4}, {4, -10}, {-4, -10}, {-10, -4}, {-10, 4}, {-4, 10}, {4, 10}}) {
      corners.push_back({std::ldexp(x, size), std::ldexp(y, size), std::ldexp(1.0, size)});
    }
    LightIrradiance light(AreaLight{ConvexPolygon::from_points(corners), true}, 1, PreparedObstacles({}));
    return light.at({0, 0, 0}, {0.3, 0, -1});
  };
  const Irradiance plain = irradiance(0);
  ASSERT_GT(plain.value, 0.01);
  for (const int size : {-1000, -600, 400}) {
    const Irradiance e = irradiance(size);
    EXPECT_LE(std::fabs(e.value - plain.value), e.error_bound + plain.error_bound) << size;
    EXPECT_LE(e.error_bound, 1e-9) << size;
  }
}

TEST(LightIrradianceRegression, AnIntervalThatBeginsAtThePointIsInfiniteAndNeverNoNumber) {
  const LinearLight light{{1, 1, 0}, {-1, 0, 1}};
  const Rational least(5e-324);
  const std::vector<std::array<Rational, 2>> intervals = {{Rational(0), least}, {least, least}};
  const Irradiance e = linear_irradiance(light, intervals, {1, 1, 0}, {-1, 1, -0x1.fffffffffffffp-1});
  EXPECT_EQ(e.value, HUGE_VAL);
  EXPECT_EQ(e.error_bound, HUGE_VAL);
}

TEST(LightIrradianceRegression, StrengthsThatUnderflowKeepABound) {
  LightIrradiance point(PointLight{{0, 0, 1}}, 1e-310, PreparedObstacles({}));
  LightIrradiance plain(PointLight{{0, 0, 1}}, 1, PreparedObstacles({}));
  const Irradiance e = point.at({.3, .7, 0}, {.1, .2, .7});
  EXPECT_NEAR(e.value, 1e-310 * plain.at({.3, .7, 0}, {.1, .2, .7}).value, e.error_bound);
  EXPECT_GT(e.error_bound, 0);
}

TEST(LightIrradianceRegression, InUmbraNothingIsGivenExactly) {
  const std::vector<ConvexBlocker> blockers = {ConvexPolygon::from_points({{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}})};
  for (const Light& light : {Light(LinearLight{{-1, 0, 2}, {1, 0, 2}}), Light(PointLight{{0, 0, 2}})}) {
    LightIrradiance irradiance(light, 1, PreparedObstacles({blockers, {}}));
    const Irradiance e = irradiance.at({0, 0, 0}, {0, 0, 1});
    EXPECT_EQ(e.value, 0);
    EXPECT_EQ(e.error_bound, 0);
  }
}

}  // namespace
}  // namespace gnomon
