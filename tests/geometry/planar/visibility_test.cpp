#include "gnomon/flatland.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "apps/proof/laws/flatland_cases.h"
#include "apps/proof/laws/planar_definition.h"
#include "geometry/numbers/rounding.h"
#include "geometry/planar/visibility_query.h"

namespace gnomon::planar {
namespace {

using laws::Domain;
using laws::FlatlandCase;
using laws::Layout;
using testing::ElementsAre;

LightVisibility visibility(const std::vector<Point2>& light, const std::vector<BlockerSegment>& blockers) {
  return LightVisibility(Flatland::from_points(light, blockers));
}

Region region_with(const Rational& f) {
  return f == 1 ? Region::lit : f == 0 ? Region::umbra : Region::penumbra;
}

/// The intervals, their named ends placed exactly, are those of the definition; the doubles keep their bounds.
void expect_definition(const LightVisibility& visibility, const Viewpoint& from) {
  const VisibilityQuery query(visibility, from);
  const VisibleLight seen = query.visible_light();
  const ExactPoint p = from.exact();
  const laws::ExactVector at{p.x, p.y, 0};
  const Flatland& flatland = visibility.flatland();
  const Rational f = laws::visible_fraction(flatland.light(), flatland.blockers(), at);
  RC_ASSERT(seen.region == region_with(f));
  RC_ASSERT(query.fraction() == f);
  if (flatland.has_point_light()) return;
  const auto parts = laws::visible_parts(flatland.light(), flatland.blockers(), at);
  RC_ASSERT(seen.intervals.size() == parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& [start, end] = seen.intervals[i];
    RC_ASSERT(query.place(start.name) == parts[i].from);
    RC_ASSERT(query.place(end.name) == parts[i].to);
    RC_ASSERT(CGAL::abs(Rational(Rational(start.t) - parts[i].from)) <= Rational(start.error));
    RC_ASSERT(CGAL::abs(Rational(Rational(end.t) - parts[i].to)) <= Rational(end.error));
    RC_ASSERT(start.error < 1e-9);
  }
  const VisibleFraction rounded = visible_fraction(seen);
  RC_ASSERT(CGAL::abs(Rational(Rational(rounded.value) - f)) <= Rational(rounded.error));
}

void expect_definition(const FlatlandCase& drawn) {
  RC_LOG() << laws::description(drawn);
  expect_definition(LightVisibility(drawn.flatland()), Viewpoint(drawn.point));
}

RC_GTEST_PROP(PlanarVisibilityAgreement, SeesWhatTheDefinitionLeavesVisible, ()) {
  expect_definition(*laws::flatland_cases(Domain::random, Layout::any));
}

RC_GTEST_PROP(PlanarVisibilityAgreement, SeesItOneUlpOffAndFarFromTheOrigin, ()) {
  expect_definition(*laws::flatland_cases(Domain::near_degenerate, Layout::any));
}

RC_GTEST_PROP(PlanarVisibilityAgreement, SeesItAmongManyBlockers, ()) {
  expect_definition(*laws::flatland_cases(Domain::random, Layout::any, 30));
}

RC_GTEST_PROP(PlanarVisibilityAgreement, SeesItFromConstructedPoints, ()) {
  const FlatlandCase drawn = *laws::flatland_cases(Domain::random, Layout::any);
  const Rational share(*rc::gen::inRange(-7, 8), 7);
  const Point2& towards = drawn.blockers.empty() ? drawn.light.back() : drawn.blockers.front()[1];
  const Rational x = Rational(drawn.point.x) + share * (Rational(towards.x) - Rational(drawn.point.x));
  const Rational y = Rational(drawn.point.y) + share * (Rational(towards.y) - Rational(drawn.point.y));
  RC_LOG() << laws::description(drawn);
  expect_definition(LightVisibility(drawn.flatland()), Viewpoint(ExactPoint{x, y}));
}

TEST(LightVisibility, NamesTheEndsOfWhatIsVisible) {
  const LightVisibility row = visibility({{-3, 4}, {3, 4}}, {{{{-2, 2}, {-1, 2}}}, {{{0, 2}, {1, 2}}}});
  const VisibleLight seen = row.visible_light({0, 0});
  EXPECT_EQ(seen.region, Region::penumbra);
  ASSERT_EQ(seen.intervals.size(), 2u);
  EXPECT_EQ(seen.intervals[0].from.name, (EventPoint{EventPointKind::blocker_end, 0, 1}));
  EXPECT_EQ(seen.intervals[0].to.name, (EventPoint{EventPointKind::blocker_end, 1, 0}));
  EXPECT_EQ(seen.intervals[1].to.name, (EventPoint{EventPointKind::light_end, 0, 1}));
  EXPECT_EQ(row.exact_fraction({0, 0}).exact, "1/2");
}

TEST(PlanarVisibilityDegenerate, BlockersThatShareAnEndLeaveNoGap) {
  const LightVisibility roof = visibility({{-1, 4}, {1, 4}}, {{{{-3, 1}, {0, 2}}}, {{{0, 2}, {3, 1}}}});
  EXPECT_EQ(roof.region({0, 0}), Region::umbra);
  const LightVisibility slit = visibility({{-1, 4}, {1, 4}}, {{{{-3, 1}, {0, 2}}}, {{{0x1p-60, 2}, {3, 1}}}});
  EXPECT_EQ(slit.region({0, 0}), Region::penumbra);
}

TEST(PlanarVisibilityDegenerate, ABlockerSeenEdgeOnHidesNothingOfALinearLight) {
  EXPECT_EQ(visibility({{-1, 4}, {1, 4}}, {{{{0, 1}, {0, 2}}}}).region({0, 0}), Region::lit);
  EXPECT_EQ(visibility({{0, 4}}, {{{{0, 1}, {0, 2}}}}).region({0, 0}), Region::umbra);
}

TEST(PlanarVisibilityDegenerate, OnTheLightsLineOneBlockerHidesWhatLiesBeyond) {
  const LightVisibility crossed = visibility({{0, 0}, {4, 0}}, {{{{1, -1}, {1, 1}}}});
  EXPECT_EQ(crossed.exact_fraction({-1, 0}).exact, "1/4");
  EXPECT_EQ(crossed.exact_fraction({0.5, 0}).exact, "1/4");
  EXPECT_EQ(crossed.exact_fraction({2, 0}).exact, "3/4");
  EXPECT_EQ(crossed.exact_fraction({1, 0}).exact, "1");
}

TEST(LightVisibility, NeedsALightAndProperSegments) {
  EXPECT_ANY_THROW(visibility({}, {}));
  EXPECT_ANY_THROW(visibility({{0, 0}, {0, 0}}, {}));
  EXPECT_ANY_THROW(visibility({{0, 0}}, {{{{1, 1}, {1, 1}}}}));
}

}  // namespace
}  // namespace gnomon::planar
