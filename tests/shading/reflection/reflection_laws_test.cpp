#include <gtest/gtest.h>

#include <boost/multiprecision/mpfi.hpp>
#include <cmath>
#include <numbers>

#include "gnomon/reflection.h"
#include "tests/shading/reflection/drawn_views.h"

namespace gnomon {
namespace {

using namespace test_support;

Reflection seen_of(const Light& light, const View& view, ReflectionModel model, int n,
                   const std::vector<ConvexBlocker>& blockers = {}) {
  return LightReflection(light, PreparedObstacles({blockers, {}})).at(view, model, n);
}

void expect_same(const Irradiance& a, const Irradiance& b) {
  EXPECT_LE(std::fabs(a.value - b.value), 1.01 * (a.error_bound + b.error_bound) + 1e-15 * a.value);
}

void expect_same(const Reflection& a, const Reflection& b) {
  expect_same(a.received, b.received);
  expect_same(a.lobe, b.lobe);
}

Irradiance sum(const Irradiance& a, const Irradiance& b) {
  return {a.value + b.value, a.error_bound + b.error_bound};
}

/// A surface that faces up and an eye somewhere above it.
View drawn_view(Dice& dice) {
  const Point3 e = drawn_vector(dice);
  return {{between(dice, -1, 1), between(dice, -1, 1), 0}, {0, 0, 1}, {e.x, e.y, std::fabs(e.z) + 0.05}};
}

class ReflectionLaw : public ::testing::TestWithParam<ReflectionModel> {};

TEST_P(ReflectionLaw, PartsOfALightAddUpAndItsDirectionDoesNotMatter) {
  Dice dice(51);
  for (int round = 0; round < 40; ++round) {
    const View view = drawn_view(dice);
    const int n = dice.draw(0, 60);
    const Point3 a{-2, dice.draw(-8, 8) / 8.0, 2}, b{2, dice.draw(-8, 8) / 8.0, 4},
        middle = added(added(a, -0.5, a), 0.5, b);
    const Reflection whole = seen_of(LinearLight{a, b}, view, GetParam(), n);
    expect_same(whole, seen_of(LinearLight{b, a}, view, GetParam(), n));
    const Reflection left = seen_of(LinearLight{a, middle}, view, GetParam(), n);
    const Reflection right = seen_of(LinearLight{middle, b}, view, GetParam(), n);
    expect_same(whole, {sum(left.received, right.received), sum(left.lobe, right.lobe)});
  }
}

TEST_P(ReflectionLaw, PiecesOfAPolygonAddUpWhateverItsFirstCorner) {
  Dice dice(52);
  const auto lamp = [](const std::vector<Point3>& p) { return AreaLight{ConvexPolygon::from_points(p), true}; };
  for (int round = 0; round < 30; ++round) {
    const View view = drawn_view(dice);
    const int n = dice.draw(0, 60);
    const Point3 a{-1, -1, 2}, b{-1, 1, 2}, c{1, 1, 2}, d{1, -1, 2};
    const Reflection whole = seen_of(lamp({a, b, c, d}), view, GetParam(), n);
    expect_same(whole, seen_of(lamp({c, d, a, b}), view, GetParam(), n));
    const Reflection left = seen_of(lamp({a, b, c}), view, GetParam(), n);
    const Reflection right = seen_of(lamp({a, c, d}), view, GetParam(), n);
    expect_same(whole, {sum(left.received, right.received), sum(left.lobe, right.lobe)});
    EXPECT_LE(whole.lobe.value,
              (GetParam() == ReflectionModel::phong || GetParam() == ReflectionModel::blinn ? whole.received.value
                                                                                            : 2 * std::numbers::pi) +
                  1e-12);
  }
}

TEST_P(ReflectionLaw, TurningAndScalingTheSceneChangesNothing) {
  Dice dice(53);
  const auto turned = [](const Point3& p) { return Point3{p.y, -p.z, -p.x}; };
  const auto larger = [](const Point3& p) { return Point3{1024 * p.x, 1024 * p.y, 1024 * p.z}; };
  for (int round = 0; round < 30; ++round) {
    const View view = drawn_view(dice);
    const LinearLight tube{{-2, 0.5, 2}, {1, dice.draw(-4, 4) / 4.0, 3}};
    const Reflection unturned = seen_of(tube, view, GetParam(), 20);
    const View turned_view{turned(view.point), turned(view.normal), turned(view.to_eye)};
    expect_same(unturned, seen_of(LinearLight{turned(tube.start), turned(tube.end)}, turned_view, GetParam(), 20));
    Reflection far = seen_of(LinearLight{larger(tube.start), larger(tube.end)},
                             {larger(view.point), view.normal, view.to_eye}, GetParam(), 20);
    for (Irradiance* e : {&far.received, &far.lobe}) *e = {1024 * e->value, 1024 * e->error_bound};
    expect_same(unturned, far);
  }
}

TEST_P(ReflectionLaw, ABlockerMoreGivesNothingMore) {
  Dice dice(54);
  for (int round = 0; round < 30; ++round) {
    const View view = drawn_view(dice);
    const LinearLight tube{{-2, 0.5, 4}, {1, dice.draw(-4, 4) / 4.0, 5}};
    const double x = dice.draw(-8, 8) / 4.0;
    const ConvexBlocker board = ConvexPolygon::from_points({{x, -1, 2}, {x + 1, -1, 2}, {x + 1, 2, 2.5}, {x, 2, 2.5}});
    const Irradiance open = seen_of(tube, view, GetParam(), 9).lobe,
                     behind = seen_of(tube, view, GetParam(), 9, {board}).lobe;
    EXPECT_LE(behind.value, open.value + open.error_bound + behind.error_bound);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, ReflectionLaw, ::testing::ValuesIn(all_models));

TEST(ReflectionLaws, OfThePhongAndBlinnModelsLightAndEyeMayChangePlaces) {
  Dice dice(55);
  for (const ReflectionModel model : {ReflectionModel::phong, ReflectionModel::blinn}) {
    for (int round = 0; round < 100; ++round) {
      Point3 e = drawn_vector(dice), l = drawn_vector(dice);
      e.z = std::fabs(e.z) + 0.1, l.z = std::fabs(l.z) + 0.1;
      const auto brdf = [&](const Point3& eye, const Point3& light) {
        const Reflection r =
            seen_of(DirectionalLight{{-light.x, -light.y, -light.z}}, {{0, 0, 0}, {0, 0, 1}, eye}, model, 12);
        return r.lobe.value / r.received.value;
      };
      EXPECT_NEAR(brdf(e, l), brdf(l, e), 1e-13);
    }
  }
}

/// (n+1) / (2 pi) tau^n tends to 1 where R meets the inside, to 1/2 on an edge, at a corner to its angle over 2 pi.
TEST(ReflectionLaws, SharpLobesSeeTheLightsInsideEdgeOrCorner) {
  const AreaLight lamp{ConvexPolygon::from_points({{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}})};
  const auto share = [&](const Point3& towards) {
    const View view{{0, 0, 0}, {0, 0, 1}, {-towards.x, -towards.y, towards.z}};
    return 1001 / (2 * std::numbers::pi) * seen_of(lamp, view, ReflectionModel::phong_classic, 1000).lobe.value;
  };
  EXPECT_NEAR(share({0.25, 0.5, 1}), 1, 1e-12);
  EXPECT_NEAR(share({1, 0, 1}), 0.5, 1e-12);
  EXPECT_NEAR(share({1, 1, 1}), 1.0 / 3, 1e-9) << "a right angle, seen aslant: 120 degrees";
  EXPECT_NEAR(share({2, 2, 1}), 0, 1e-12);
}

/// What the papers print and what is right: the missing length of [PA90] §3, and R . L for N . H in [P93] (3.8).
TEST(ReflectionRegression, ThePapersCounterexamples) {
  const View view{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  EXPECT_NEAR(seen_of(LinearLight{{0, 0, 1}, {2, 0, 1}}, view, ReflectionModel::phong, 0).received.value, 0.8944271910,
              1e-10);
  const LinearLight tube{{-5, 0, 1}, {5, 0, 1}};
  EXPECT_NEAR(seen_of(tube, view, ReflectionModel::phong_classic, 64).lobe.value, 0.31211, 5e-6);
  EXPECT_NEAR(seen_of(tube, view, ReflectionModel::blinn_classic, 64).lobe.value, 0.62421, 5e-6);
  EXPECT_NEAR(seen_of(tube, view, ReflectionModel::blinn_classic, 256).lobe.value, 0.31302, 5e-6);
}

using Enclosed =
    boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<25>, boost::multiprecision::et_off>;

/// The definition's lobe for a tube along x at height z over a surface that faces up, between two places, as an
/// interval.
Enclosed lobe_between(double from, double to, double z, const Point3& e, ReflectionModel model, int n) {
  const Enclosed x = hull(Enclosed(from), Enclosed(to)), square = x * x + z * z, r = sqrt(square);
  const Enclosed length = sqrt(Enclosed(e.x) * e.x + Enclosed(e.y) * e.y + Enclosed(e.z) * e.z);
  const Enclosed ex = e.x / length, ey = e.y / length, ez = e.z / length, lx = x / r, lz = z / r;
  const bool is_halfway = model == ReflectionModel::blinn || model == ReflectionModel::blinn_classic;
  const Enclosed hx = lx + ex, hz = lz + ez;
  Enclosed base = is_halfway ? Enclosed(hz / sqrt(hx * hx + ey * ey + hz * hz)) : Enclosed(ez * lz - ex * lx);
  if (lower(base) < 0) base = hull(Enclosed(0), Enclosed(upper(base) > 0 ? upper(base) : 0));
  Enclosed value = 1 / square;
  for (int k = 0; k < n; ++k) value *= base;
  return model == ReflectionModel::phong || model == ReflectionModel::blinn ? Enclosed(value * lz) : value;
}

TEST_P(ReflectionLaw, IntervalsOfTheDefinitionHoldTheLobe) {
  Dice dice(56);
  for (int round = 0; round < 4; ++round) {
    const double a = -1 - dice.draw(0, 8) / 8.0, b = 1 + dice.draw(0, 8) / 8.0, z = 1 + dice.draw(0, 8) / 8.0;
    const Point3 e{dice.draw(-8, 8) / 8.0, dice.draw(-8, 8) / 8.0, dice.draw(1, 8) / 8.0};
    const int n = dice.draw(0, 12) + 1, pieces = 4096;
    Enclosed total = 0;
    for (int k = 0; k < pieces; ++k) {
      const double from = a + (b - a) * k / pieces, to = k + 1 == pieces ? b : a + (b - a) * (k + 1) / pieces;
      total += (Enclosed(to) - Enclosed(from)) * lobe_between(from, to, z, e, GetParam(), n);
    }
    const Irradiance lobe = seen_of(LinearLight{{a, 0, z}, {b, 0, z}}, {{0, 0, 0}, {0, 0, 1}, e}, GetParam(), n).lobe;
    EXPECT_LE(lower(total), lobe.value + lobe.error_bound);
    EXPECT_GE(upper(total), lobe.value - lobe.error_bound);
    EXPECT_LT(upper(total) - lower(total), 2e-2 * (1 + lobe.value)) << n;
  }
}

}  // namespace
}  // namespace gnomon
