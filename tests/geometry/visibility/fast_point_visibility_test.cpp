#include "geometry/visibility/fast_point_visibility.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "apps/proof/laws/visibility_cases.h"
#include "gnomon/visibility.h"
#include "tests/support/dice.h"

namespace gnomon {
namespace {

using laws::BlockerKind;
using laws::Domain;
using laws::LightKind;
using laws::VisibilityCase;
using test_support::Dice;

FastPointVisibility::SmallLight small(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light)) return *point;
  return std::get<DirectionalLight>(light);
}

void check_agreement(Domain domain, LightKind kind, int most_blockers) {
  int decided = 0;
  int asked = 0;
  const auto cases =
      laws::visibility_cases(domain, {{kind}, {BlockerKind::polygon, BlockerKind::solid}, most_blockers});
  EXPECT_TRUE(rc::check("levels agree", [&] {
    const VisibilityCase drawn = *cases;
    RC_LOG() << laws::description(drawn);
    FastPointVisibility fast(small(drawn.light), BlockerSet(drawn.blockers));
    ++asked;
    const auto region = fast.region_from(drawn.point);
    if (!region) return;
    ++decided;
    RC_ASSERT(name(*region) == name(exact_visibility(drawn.light, {drawn.blockers, {}}, drawn.point).region));
  }));
  EXPECT_GE(decided, asked / 2) << "of " << asked;
}

TEST(FastPointVisibilityAgreement, PointLightsMatchTheExactLevelOnSmallIntegers) {
  check_agreement(Domain::random, LightKind::point, 4);
}
TEST(FastPointVisibilityAgreement, PointLightsMatchTheExactLevelNearDegeneracy) {
  check_agreement(Domain::near_degenerate, LightKind::point, 4);
}
TEST(FastPointVisibilityAgreement, DirectionsMatchTheExactLevelOnSmallIntegers) {
  check_agreement(Domain::random, LightKind::direction, 4);
}
TEST(FastPointVisibilityAgreement, DirectionsMatchTheExactLevelNearDegeneracy) {
  check_agreement(Domain::near_degenerate, LightKind::direction, 4);
}

/// Enough triangles for the hierarchy; lines of sight often run along its boxes.
TEST(FastPointVisibilityAgreement, TheHierarchyDropsNoBlocker) {
  EXPECT_TRUE(rc::check([&] {
    Dice dice;
    if (!dice.once_in(20)) return;
    const auto at = [&](int low, int high) {
      return Point3{1.0 * dice.draw(-6, 6), 1.0 * dice.draw(-6, 6), 1.0 * dice.draw(low, high)};
    };
    std::vector<ConvexBlocker> blockers;
    while (blockers.size() < 40) {
      const std::vector<Point3> triangle = {at(1, 3), at(1, 3), at(1, 3)};
      if (!ConvexPolygon::defect(triangle)) blockers.push_back(ConvexPolygon::from_points(triangle));
    }
    for (int i = 0; i < 20; ++i) {
      const Point3 p = at(-1, 2);
      Light light = PointLight{at(3, 5)};
      if (dice.once_in(2)) light = DirectionalLight{{1.0 * dice.draw(-1, 1), 1.0 * dice.draw(-1, 1), -1}};
      const auto region = FastPointVisibility(small(light), BlockerSet(blockers)).region_from(p);
      if (region) RC_ASSERT(name(*region) == name(exact_visibility(light, {blockers, {}}, p).region));
    }
  }));
}

TEST(FastPointVisibilityDegenerate, AGrazedEdgeHides) {
  const std::vector<ConvexBlocker> board = {ConvexPolygon::from_points({{0, -1, 1}, {2, -1, 1}, {2, 1, 1}, {0, 1, 1}})};
  EXPECT_EQ(FastPointVisibility(PointLight{{0, 0, 2}}, BlockerSet(board)).region_from({0, 0, 0}), Region::umbra);
  EXPECT_EQ(FastPointVisibility(PointLight{{0, 0, 2}}, BlockerSet(board)).region_from({-1e-300, 0, 0}), Region::lit);
  EXPECT_EQ(FastPointVisibility(DirectionalLight{{0, 0, -1}}, BlockerSet(board)).region_from({0, 0, 0}), Region::umbra);
  EXPECT_EQ(FastPointVisibility(DirectionalLight{{0, 0, -1}}, BlockerSet(board)).region_from({0, 0, 1}), Region::lit);
}

TEST(FastPointVisibilityDegenerate, APointStrictlyInsideASolidIsInUmbraAndOneOnItIsNot) {
  const std::vector<ConvexBlocker> solid = {ConvexSolid::hull_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}})};
  FastPointVisibility fast(PointLight{{-1, .5, .5}}, BlockerSet(solid));
  EXPECT_EQ(fast.region_from({.5, .5, .5}), Region::umbra);
  EXPECT_EQ(fast.region_from({0, .5, .5}), Region::lit);
}

}  // namespace
}  // namespace gnomon
