#include "gnomon/flatland_receiver.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "apps/proof/laws/flatland_cases.h"
#include "apps/proof/laws/planar_definition.h"
#include "geometry/numbers/rounding.h"

namespace gnomon {
namespace {

using planar::BlockerSegment;
using planar::Flatland;
using planar::LightVisibility;

LightVisibility visibility(const std::vector<Point2>& light, const std::vector<BlockerSegment>& blockers) {
  return LightVisibility(Flatland::from_points(light, blockers));
}

/// The integral over the visible parts of the definition, along the light by the midpoint rule:
/// cos(angle to the normal) times the angle under which a short piece is seen.
double summed(const laws::FlatlandCase& drawn, const Point2& normal) {
  const Point2 &a = drawn.light[0], &b = drawn.light[1], &p = drawn.point;
  const double dx = b.x - a.x, dy = b.y - a.y;
  double sum = 0;
  for (const auto& [from, to] : laws::visible_parts(drawn.light, drawn.blockers, laws::exact(p))) {
    const double start = nearest_double(from), length = nearest_double(Rational(to - from));
    constexpr int pieces = 4000;
    for (int i = 0; i < pieces; ++i) {
      const double t = start + length * (i + 0.5) / pieces;
      const double x = a.x + t * dx - p.x, y = a.y + t * dy - p.y;
      const double square = x * x + y * y;
      const double cosine = (x * normal.x + y * normal.y) / std::sqrt(square) / std::hypot(normal.x, normal.y);
      if (cosine > 0) sum += cosine * std::fabs(x * dy - y * dx) / square * length / pieces;
    }
  }
  return sum;
}

/// A case with a linear light, and with the point off its line.
laws::FlatlandCase drawn_case() {
  auto drawn = *laws::flatland_cases(laws::Domain::random, laws::Layout::any);
  Point2& p = drawn.point;
  const Point2 a = drawn.light[0];
  if (drawn.light.size() == 1) drawn.light.push_back({a.x + 2, a.y + 1});
  const double dx = drawn.light[1].x - a.x, dy = drawn.light[1].y - a.y;
  const double area = dx * (p.y - a.y) - dy * (p.x - a.x);
  if (std::fabs(area) < 0.5 * std::hypot(dx, dy)) p = {p.x - dy, p.y + dx};
  return drawn;
}

RC_GTEST_PROP(PlanarIrradianceAgreement, IsTheSumOverVisiblePieces, ()) {
  const laws::FlatlandCase drawn = drawn_case();
  const Point2 normal{double(*rc::gen::inRange(-3, 4)), 1.0 + *rc::gen::inRange(0, 3)};
  RC_LOG() << laws::description(drawn);
  const BoundedIrradiance e = planar_irradiance(LightVisibility(drawn.flatland()), {drawn.point, normal});
  RC_ASSERT(std::fabs(e.value - summed(drawn, normal)) < 1e-4);
  RC_ASSERT(e.error < 1e-13);
}

TEST(PlanarIrradiance, KeepsItsBoundAroundAClosedForm) {
  // From (0, 0) the sines to (-3, 4) and (5, 12) are -3/5 and 5/13; only these ends count, not the light's place.
  const BoundedIrradiance e = planar_irradiance(visibility({{-3, 4}, {5, 12}}, {}), {{0, 0}, {0, 2}}, 2);
  const Rational exact = 2 * (Rational(3, 5) + Rational(5, 13));
  EXPECT_LE(CGAL::abs(Rational(Rational(e.value) - exact)), Rational(e.error));
  EXPECT_LT(e.error, 1e-15 * 8);
}

TEST(PlanarIrradiance, IsClippedByTheHorizon) {
  const LightVisibility open = visibility({{-4, -3}, {3, 4}}, {});
  const BoundedIrradiance e = planar_irradiance(open, {{0, 0}, {0, 1}});
  EXPECT_LE(std::fabs(e.value - 1.6), e.error);
  EXPECT_EQ(planar_irradiance(open, {{0, 0}, {1, -1}}).value, 0);
}

TEST(PlanarIrradianceDegenerate, OnTheLightsLineNothingArrives) {
  EXPECT_EQ(planar_irradiance(visibility({{0, 1}, {0, 2}}, {}), {{0, 0}, {0, 1}}).value, 0);
}

TEST(PlanarIrradiance, NeitherTheNormalsLengthNorTheSizeOfAllMatters) {
  for (const int size : {-1000, -520, 0, 300, 900}) {
    const auto scaled = [&](double x, double y) { return Point2{std::ldexp(x, size), std::ldexp(y, size)}; };
    const planar::LightVisibility light = visibility({scaled(0, 0), scaled(1, 0)}, {});
    for (const double length : {1e-300, 1e-200, 1.0, 1e200}) {
      const BoundedIrradiance e = planar_irradiance(light, {scaled(0.5, 1), {0, -length}});
      EXPECT_NEAR(e.value, 1 / std::sqrt(1.25), e.error) << size << " " << length;
      EXPECT_LT(e.error, 1e-14) << size << " " << length;
    }
  }
}

TEST(PlanarIrradiance, NeedsALinearLightAndANormal) {
  EXPECT_ANY_THROW(planar_irradiance(visibility({{0, 1}}, {}), {{0, 0}, {0, 1}}));
  EXPECT_ANY_THROW(planar_irradiance(visibility({{0, 1}, {1, 1}}, {}), {{0, 0}, {0, 0}}));
}

}  // namespace
}  // namespace gnomon
