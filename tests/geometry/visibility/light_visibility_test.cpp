#include "geometry/visibility/light_visibility.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "apps/laws/sight_cases.h"

namespace gnomon {
namespace {

using laws::BlockerKind;
using laws::Domain;
using laws::LightKind;
using laws::SightCase;

bool within_bounds(double fraction, double bound, const Visibility& exact) {
  return std::fabs(fraction - exact.fraction) <= bound + exact.error_bound;
}

/// Cases in every position, degenerate and nearly so: whatever the fast level says, the exact level says too.
void check_fast_level(Domain domain, int most_blockers) {
  int decided = 0;
  int asked = 0;
  const auto cases =
      laws::sight_cases(domain, {{LightKind::polygon}, {BlockerKind::polygon, BlockerKind::solid}, most_blockers});
  EXPECT_TRUE(rc::check("levels agree", [&] {
    const SightCase drawn = *cases;
    FastVisibility fast(std::get<AreaLight>(drawn.light), BlockerSet(drawn.blockers));
    const std::optional<LightSeen> seen = fast.seen_from(drawn.point);
    ++asked;
    if (!seen) return;
    ++decided;
    const Visibility exact = exact_visibility(drawn.light, {drawn.blockers, {}}, drawn.point);
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

TEST(LightVisibilityAgreement, EveryLightIsAnsweredAsTheExactLevelDoes) {
  const auto cases = laws::sight_cases(Domain::random, {{LightKind::point, LightKind::direction, LightKind::segment,
                                                         LightKind::polygon, LightKind::rounded_polygon},
                                                        {BlockerKind::polygon, BlockerKind::solid},
                                                        3});
  EXPECT_TRUE(rc::check("answers agree", [&] {
    const SightCase drawn = *cases;
    LightVisibility both(drawn.light, PreparedObstacles({drawn.blockers, {}}));
    const Visibility seen = both.at(drawn.point);
    const Visibility exact = exact_visibility(drawn.light, {drawn.blockers, {}}, drawn.point);
    RC_ASSERT(name(seen.region) == name(exact.region));
    RC_ASSERT(within_bounds(seen.fraction, seen.error_bound, exact));
    RC_ASSERT(seen.error_bound <= 1e-9);
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
