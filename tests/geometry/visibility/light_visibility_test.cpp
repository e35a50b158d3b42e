#include "gnomon/visibility.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "apps/proof/laws/visibility_cases.h"
#include "geometry/visibility/fast_visibility.h"

namespace gnomon {
namespace {

using laws::BlockerKind;
using laws::Domain;
using laws::LightKind;
using laws::VisibilityCase;

bool within_bounds(double fraction, double bound, const Visibility& exact) {
  return std::fabs(fraction - exact.fraction) <= bound + exact.error_bound;
}

/// Cases in every position, degenerate and nearly so: whatever the fast level says, the exact level says too.
void check_fast_level(Domain domain, int most_blockers) {
  int decided = 0;
  int asked = 0;
  const auto cases =
      laws::visibility_cases(domain, {{LightKind::polygon}, {BlockerKind::polygon, BlockerKind::solid}, most_blockers});
  EXPECT_TRUE(rc::check("levels agree", [&] {
    const VisibilityCase drawn = *cases;
    FastVisibility fast(std::get<AreaLight>(drawn.light), BlockerSet(drawn.blockers));
    const std::optional<VisibleAreaLight> seen = fast.visible_from(drawn.point);
    ++asked;
    if (!seen) return;
    ++decided;
    const Visibility exact = exact_visibility(drawn.light, {drawn.blockers, {}}, drawn.point);
    RC_LOG() << laws::description(drawn);
    RC_ASSERT(name(seen->region) == name(exact.region));
    RC_ASSERT(within_bounds(seen->fraction, seen->error_bound, exact));
  }));
  EXPECT_GE(decided, asked / 3) << "of " << asked;
}

TEST(FastVisibilityAgreement, MatchesTheExactLevelOnSmallIntegers) {
  check_fast_level(Domain::random, 6);
}

TEST(FastVisibilityAgreement, MatchesTheExactLevelNearDegeneracy) {
  check_fast_level(Domain::near_degenerate, 6);
}

TEST(FastVisibilityRegression, ASolidBulgesThroughTheLightsPlaneTowardsThePoint) {
  const Light light = AreaLight{ConvexPolygon::from_points({{2, 2, 2}, {0, 0, 0}, {0, 1, 1}}), true};
  const std::vector<ConvexBlocker> blockers = {ConvexSolid::hull_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}})};
  LightVisibility visibility(light, PreparedObstacles({blockers, {}}));
  EXPECT_EQ(visibility.at({0, 6, -1}).region, Region::penumbra);
}

/// A point of the plane 4x + 3y = 0, moved along its normal.
Point3 beside(double s, double t, double distance) {
  return {3 * s + 4 * distance, -4 * s + 3 * distance, t};
}

TEST(FastVisibilityRegression, BothSidesOfALightWithNearlyCollinearCornersMeasureTheSameArea) {
  const std::vector<Point3> corners = {
      {0x1.8p+1, -0x1p+2, 0x1p-2},
      {0x1.d8b83d5560368p+0, -0x1.3b257e38eacfp+1, 0x1.e94880da7537cp-1},
      {0x1.d8b83d556035p-1, -0x1.3b257e38eacep+0, 0x1.e94880da75364p-2},
      {0, 0, 0},
  };
  const std::vector<Point3> other_way = {corners[1], corners[0], corners[3], corners[2]};
  for (const double distance : {-1.0, 1.0}) {
    const auto hide = [&](double s, double t) { return beside(s, t, distance / 2); };
    const std::vector<ConvexBlocker> blockers = {
        ConvexPolygon::from_points({hide(-5, 0.45), hide(5, 0.45), hide(5, -5), hide(-5, -5)})};
    const Point3 p = beside(0.25, 0.5, distance);
    std::vector<Visibility> seen;
    for (const std::vector<Point3>& loop : {corners, other_way}) {
      LightVisibility visibility(AreaLight{ConvexPolygon::from_points(loop), true}, PreparedObstacles({blockers, {}}));
      seen.push_back(visibility.at(p));
    }
    EXPECT_LE(std::fabs(seen[0].fraction - seen[1].fraction), seen[0].error_bound + seen[1].error_bound) << distance;
  }
}

/// Two rectangles across each other before a light whose plane's distance is less than its rounding.
std::size_t pieces_around_a_cross(double distance) {
  const AreaLight light{ConvexPolygon::from_points({{3, -4, 1}, {-3, 4, 1}, {-3, 4, -1}, {3, -4, -1}}), true};
  const auto rectangle = [&](double width, double height) {
    const auto corner = [&](double s, double t) { return beside(s * distance, t * distance, distance / 2); };
    return ConvexPolygon::from_points(
        {corner(-width, -height), corner(width, -height), corner(width, height), corner(-width, height)});
  };
  const std::vector<ConvexBlocker> blockers = {rectangle(0.5, 0.3), rectangle(0.3, 0.5)};
  FastVisibility visibility(light, BlockerSet(blockers));
  return visibility.visible_from(beside(0, 0, distance)).value().boundary.size();
}

TEST(FastVisibilityRegression, BlockersCrossBeforeALightNearerThanRoundingTells) {
  EXPECT_EQ(pieces_around_a_cross(1e-6), 4U + 12U);
  EXPECT_EQ(pieces_around_a_cross(1e-17), 4U + 12U);
}

TEST(LightVisibilityAgreement, EveryLightIsAnsweredAsTheExactLevelDoes) {
  const auto cases = laws::visibility_cases(
      Domain::random,
      {{LightKind::point, LightKind::direction, LightKind::segment, LightKind::polygon, LightKind::rounded_polygon},
       {BlockerKind::polygon, BlockerKind::solid},
       3});
  EXPECT_TRUE(rc::check("answers agree", [&] {
    const VisibilityCase drawn = *cases;
    LightVisibility both(drawn.light, PreparedObstacles({drawn.blockers, {}}));
    const Visibility seen = both.at(drawn.point);
    const Visibility exact = exact_visibility(drawn.light, {drawn.blockers, {}}, drawn.point);
    RC_ASSERT(name(seen.region) == name(exact.region));
    RC_ASSERT(within_bounds(seen.fraction, seen.error_bound, exact));
    RC_ASSERT(seen.error_bound <= 1e-6);
  }));
}

TEST(LightVisibility, APointInAnEnclosureIsInUmbraThoughItsLampIsInsideToo) {
  const auto corner = [](double x, double y, double z) { return Point3{4 * x, 4 * y, 4 * z}; };
  const ClosedSurface tent{{corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0), corner(0, 0, 1)},
                           {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}}};
  Obstacles obstacles{{}, {tent}};
  for (const auto& t : tent.triangles) {
    obstacles.blockers.push_back(
        ConvexPolygon::from_points({tent.vertices[t[0]], tent.vertices[t[1]], tent.vertices[t[2]]}));
  }
  const AreaLight lamp{ConvexPolygon::from_points({{.5, .5, 1}, {.5, .6, 1}, {.6, .5, 1}}), true};
  LightVisibility visibility(lamp, PreparedObstacles(obstacles));
  EXPECT_EQ(visibility.at({.5, .5, .5}).region, Region::umbra);
  EXPECT_EQ(visibility.at({-1, -1, -1}).region, Region::umbra);
}

}  // namespace
}  // namespace gnomon
