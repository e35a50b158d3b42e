#include "geometry/visibility/fast_linear_visibility.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "apps/proof/laws/visibility_cases.h"
#include "geometry/visibility/visible_part.h"
#include "gnomon/visibility.h"
#include "tests/support/dice.h"

namespace gnomon {
namespace {

using laws::BlockerKind;
using laws::Domain;
using laws::LightKind;
using laws::VisibilityCase;
using test_support::Dice;
using Interval = VisiblePart::Interval;

ConvexPolygon polygon(std::vector<Point3> points) {
  return ConvexPolygon::from_points(std::move(points));
}

/// The exact intervals, those that abut made one.
std::vector<Interval> whole_intervals(const VisibilityCase& drawn) {
  std::vector<Interval> whole;
  for (const Interval& next : exact_visible_part(drawn.light, {drawn.blockers, {}}, drawn.point).intervals) {
    if (!whole.empty() && whole.back()[1] == next[0]) {
      whole.back()[1] = next[1];
    } else {
      whole.push_back(next);
    }
  }
  return whole;
}

bool holds(const StretchEnd& end, const Rational& share) {
  return !(end.error < 1) || abs(Rational(Rational(end.share) - share)) <= Rational(end.error);
}

/// An end of the light is named as such, and an end at a blocker by it.
bool is_named(const StretchEnd& end, const Rational& share, std::size_t blockers) {
  if (!end.blocker) return share == (end.share == 0 ? 0 : 1);
  return *end.blocker < blockers && share > 0 && share < 1;
}

void expect_same(const VisibleLinearLight& seen, const VisibilityCase& drawn) {
  const Visibility exact = exact_visibility(drawn.light, {drawn.blockers, {}}, drawn.point);
  RC_ASSERT(name(seen.region) == name(exact.region));
  RC_ASSERT(std::fabs(seen.fraction - exact.fraction) <= seen.error_bound + exact.error_bound);
  const std::vector<Interval> intervals = whole_intervals(drawn);
  RC_ASSERT(seen.visible.size() == intervals.size());
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const auto& [from, to] = seen.visible[i];
    RC_ASSERT(holds(from, intervals[i][0]) && holds(to, intervals[i][1]));
    RC_ASSERT(is_named(from, intervals[i][0], drawn.blockers.size()));
    RC_ASSERT(is_named(to, intervals[i][1], drawn.blockers.size()));
  }
}

/// Whatever the fast level says, the exact level says too; and it mostly says something.
void check_agreement(Domain domain, int most_blockers) {
  int decided = 0;
  int asked = 0;
  const auto cases =
      laws::visibility_cases(domain, {{LightKind::segment}, {BlockerKind::polygon, BlockerKind::solid}, most_blockers});
  EXPECT_TRUE(rc::check("levels agree", [&] {
    const VisibilityCase drawn = *cases;
    RC_LOG() << laws::description(drawn);
    FastLinearVisibility fast(std::get<LinearLight>(drawn.light), BlockerSet(drawn.blockers));
    ++asked;
    if (const auto seen = fast.visible_from(drawn.point)) {
      ++decided;
      expect_same(*seen, drawn);
    }
  }));
  EXPECT_GE(decided, asked / 3) << "of " << asked;
}

TEST(FastLinearVisibilityAgreement, MatchesTheExactLevelBehindOneBlocker) {
  check_agreement(Domain::random, 1);
}
TEST(FastLinearVisibilityAgreement, MatchesTheExactLevelOnSmallIntegers) {
  check_agreement(Domain::random, 6);
}
TEST(FastLinearVisibilityAgreement, MatchesTheExactLevelNearDegeneracy) {
  check_agreement(Domain::near_degenerate, 6);
}

/// Blockers between point and light on small integers: they overlap as seen, and there are enough for the hierarchy.
VisibilityCase draw_between(Dice& dice, int blockers) {
  const auto at = [&](int low, int high) {
    return Point3{1.0 * dice.draw(-3, 3), 1.0 * dice.draw(-3, 3), 1.0 * dice.draw(low, high)};
  };
  VisibilityCase drawn{LinearLight{at(8, 8), at(9, 9)}, {}, at(-2, 1)};
  while (static_cast<int>(drawn.blockers.size()) < blockers) {
    const std::vector<Point3> triangle = {at(1, 7), at(1, 7), at(1, 7)};
    if (!ConvexPolygon::defect(triangle)) drawn.blockers.push_back(polygon(triangle));
  }
  return drawn;
}

TEST(FastLinearVisibilityAgreement, MatchesTheExactLevelBehindManyTriangles) {
  int decided = 0;
  int asked = 0;
  EXPECT_TRUE(rc::check("levels agree", [&] {
    Dice dice;
    const VisibilityCase drawn = draw_between(dice, dice.once_in(10) ? 30 : 4);
    FastLinearVisibility fast(std::get<LinearLight>(drawn.light), BlockerSet(drawn.blockers));
    ++asked;
    if (const auto seen = fast.visible_from(drawn.point)) {
      ++decided;
      expect_same(*seen, drawn);
    }
  }));
  EXPECT_GE(decided, asked * 19 / 20) << "of " << asked;
}

TEST(FastLinearVisibilityProperty, AddingABlockerNeverRaisesTheFraction) {
  EXPECT_TRUE(rc::check([] {
    Dice dice;
    if (!dice.once_in(10)) return;
    const VisibilityCase drawn = draw_between(dice, 8);
    double most = 1;
    for (std::size_t count = 0; count <= drawn.blockers.size(); ++count) {
      const std::span some(drawn.blockers.data(), count);
      const auto seen =
          FastLinearVisibility(std::get<LinearLight>(drawn.light), BlockerSet(some)).visible_from(drawn.point);
      if (!seen) continue;
      RC_ASSERT(seen->fraction <= most + seen->error_bound);
      most = std::fmin(most, seen->fraction + seen->error_bound);
    }
  }));
}

TEST(FastLinearVisibility, TellsWhichEdgeBoundsWhatIsSeen) {
  FastLinearVisibility fast(
      {{-1, 0, 2}, {1, 0, 2}},
      BlockerSet(std::vector<ConvexBlocker>{polygon({{0, -9, 1}, {9, -9, 1}, {9, 9, 1}, {0, 9, 1}})}));
  const auto seen = fast.visible_from({0, 0, 0});
  ASSERT_TRUE(seen && seen->visible.size() == 1);
  const auto& [from, to] = seen->visible.front();
  EXPECT_FALSE(from.blocker);
  EXPECT_EQ(to.blocker, 0u);
  EXPECT_EQ(to.edge, 3u);
  EXPECT_NEAR(to.share, 0.5, to.error);
  EXPECT_LT(seen->error_bound, 1e-13);
}

TEST(FastLinearVisibilityDegenerate, AnEdgeCoplanarWithTheLightHidesWhatItCrosses) {
  const ConvexBlocker board = polygon({{-.25, 0, 1}, {.25, 0, 1}, {.25, 5, 1}, {-.25, 5, 1}});
  FastLinearVisibility fast({{-1, 0, 2}, {1, 0, 2}}, BlockerSet(std::vector{board}));
  const auto seen = fast.visible_from({0, 0, 0});
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->region, Region::penumbra);
  EXPECT_NEAR(seen->fraction, 0.5, seen->error_bound);
}

TEST(FastLinearVisibilityDegenerate, ABlockerThatOnlyCarriesTheLightOnItsEdgeHidesNothingOrIsLeftOpen) {
  const ConvexBlocker shelf = polygon({{-2, 0, 2}, {2, 0, 2}, {2, 1, 1}, {-2, 1, 1}});
  FastLinearVisibility fast({{-1, 0, 2}, {1, 0, 2}}, BlockerSet(std::vector{shelf}));
  const auto seen = fast.visible_from({0, 0, 0});
  if (seen) {
    EXPECT_EQ(seen->region, Region::lit);
  }
}

TEST(FastLinearVisibilityProperty, NoLightLeaksThroughTheSharedEdgesOfAClosedBox) {
  std::vector<ConvexBlocker> box;
  const auto side = [&](Point3 a, Point3 b, Point3 c, Point3 d) {
    box.push_back(polygon({a, b, c}));
    box.push_back(polygon({a, c, d}));
  };
  const Point3 v[8] = {{-2, -2, 3}, {2, -2, 3}, {2, 2, 3}, {-2, 2, 3}, {-2, -2, 7}, {2, -2, 7}, {2, 2, 7}, {-2, 2, 7}};
  side(v[0], v[1], v[2], v[3]);
  side(v[4], v[5], v[6], v[7]);
  for (int k = 0; k < 4; ++k) side(v[k], v[(k + 1) % 4], v[4 + (k + 1) % 4], v[4 + k]);
  EXPECT_TRUE(rc::check([&] {
    Dice dice;
    const auto at = [&](int reach, double scale) {
      return Point3{scale * dice.draw(-reach, reach), scale * dice.draw(-reach, reach),
                    scale * dice.draw(-reach, reach)};
    };
    const Point3 a = at(1, 1);
    const Point3 b = at(1, 1);
    const LinearLight tube{{a.x, a.y, 4}, {b.x, b.y, 6}};
    const Point3 p = at(20, dice.once_in(2) ? 1 : 1.0 / 7);
    if (p.z >= 3) return;
    const auto seen = FastLinearVisibility(tube, BlockerSet(box)).visible_from(p);
    if (!seen) return;  // on the tube's line
    RC_ASSERT(name(seen->region) == "umbra");
    RC_ASSERT(seen->fraction == 0.0 && seen->error_bound == 0.0);
  }));
}

TEST(FastLinearVisibility, LeavesPointsOnItsLineAndHugeCoordinatesOpen) {
  FastLinearVisibility fast({{0, 0, 1}, {0, 0, 2}}, BlockerSet({}));
  EXPECT_FALSE(fast.visible_from({0, 0, 0}));
  EXPECT_FALSE(fast.visible_from({0, 0, 1.5}));
  EXPECT_FALSE(fast.visible_from({1e31, 0, 0}));
  EXPECT_TRUE(fast.visible_from({1, 0, 0}));
}

}  // namespace
}  // namespace gnomon
