#include "gnomon/flatland_pair.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <limits>
#include <vector>

#include "apps/proof/laws/planar_cases.h"
#include "apps/proof/laws/planar_definition.h"

namespace gnomon::planar {
namespace {

using Points = std::vector<Point2>;

Region region_at(const Points& light, const Point2& point) {
  return region_of(Pair::from_points(light, Points{{-1, 0}, {1, 0}}), point);
}

void agrees_with_the_definition(laws::Domain domain, laws::Stand stand) {
  const laws::PlanarCase drawn = *laws::planar_cases(domain, stand);
  const auto f = laws::visible_fraction(drawn.light, drawn.blocker, laws::exact(drawn.point));
  const Region expected = f == 1 ? Region::lit : f == 0 ? Region::umbra : Region::penumbra;
  RC_CLASSIFY(expected != Region::lit);
  RC_LOG() << laws::description(drawn);
  RC_ASSERT(region_of(drawn.pair(), drawn.point) == expected);
}

RC_GTEST_PROP(RegionOfAgreement, OfALightApart, ()) {
  agrees_with_the_definition(*rc::gen::element(laws::Domain::random, laws::Domain::near_degenerate),
                             laws::Stand::apart);
}

RC_GTEST_PROP(RegionOfAgreement, OfALightWhoseLineMeetsTheBlocker, ()) {
  agrees_with_the_definition(*rc::gen::element(laws::Domain::random, laws::Domain::near_degenerate),
                             laws::Stand::light_line_hits);
}

RC_GTEST_PROP(RegionOfAgreement, OfALightOnWhichTheBlockersLineHits, ()) {
  agrees_with_the_definition(*rc::gen::element(laws::Domain::random, laws::Domain::near_degenerate),
                             laws::Stand::blocker_line_hits);
}

RC_GTEST_PROP(RegionOfAgreement, OfALightOnTheBlockersLine, ()) {
  agrees_with_the_definition(*rc::gen::element(laws::Domain::random, laws::Domain::near_degenerate),
                             laws::Stand::on_one_line);
}

TEST(RegionOf, BehindTheBlockerGoesFromUmbraToPenumbraToLight) {
  const Points light{{-1, 1}, {1, 1}};
  EXPECT_EQ(region_at(light, {0, -1}), Region::umbra);
  EXPECT_EQ(region_at(light, {2, -1}), Region::penumbra);
  EXPECT_EQ(region_at(light, {4, -1}), Region::lit);
}

TEST(RegionOf, OnTheSupportingLineIsUmbraAndOnTheSeparatingLineLit) {
  const Points light{{-1, 1}, {1, 1}};
  EXPECT_EQ(region_at(light, {1, -1}), Region::umbra);
  EXPECT_EQ(region_at(light, {3, -1}), Region::lit);
}

TEST(RegionOf, OnTheBlockerIsLit) {
  EXPECT_EQ(region_at({{-1, 1}, {1, 1}}, {0, 0}), Region::lit);
  EXPECT_EQ(region_at({{0, -1}, {0, 1}}, {0, 0}), Region::lit);
  EXPECT_EQ(region_at({{0, 1}}, {0, 0}), Region::lit);
}

TEST(RegionOf, OnTheEdgeOfAPointLightsShadowIsUmbra) {
  EXPECT_EQ(region_at({{0, 1}}, {2, -1}), Region::umbra);
  EXPECT_EQ(region_at({{0, 1}}, {2.0000000000000004, -1}), Region::lit);
}

TEST(RegionOfDegenerate, BehindAnEndOnTheLightsLineIsUmbraThoughLightIsNear) {
  const Points light{{1, 1}, {1, 2}};
  EXPECT_EQ(region_at(light, {1, -5}), Region::umbra);
  EXPECT_EQ(region_at(light, {1 + std::numeric_limits<double>::epsilon(), -5}), Region::lit);
}

TEST(RegionOfDegenerate, ALightThatCrossesTheBlockersEndHidesItsLine) {
  const Points light{{1, -1}, {1, 1}};
  EXPECT_EQ(region_at(light, {1, -5}), Region::penumbra);
  EXPECT_EQ(region_at(light, {1 + std::numeric_limits<double>::epsilon(), -5}), Region::lit);
}

TEST(RegionOfDegenerate, OnTheCommonLineOfLightAndBlocker) {
  EXPECT_EQ(region_at({{2, 0}, {3, 0}}, {-2, 0}), Region::umbra);
  EXPECT_EQ(region_at({{2, 0}, {3, 0}}, {0, 0}), Region::umbra);
  EXPECT_EQ(region_at({{2, 0}, {3, 0}}, {1, 0}), Region::lit);
  EXPECT_EQ(region_at({{2, 0}, {3, 0}}, {5, 0}), Region::lit);
  EXPECT_EQ(region_at({{0, 0}, {3, 0}}, {5, 0}), Region::penumbra);
  EXPECT_EQ(region_at({{0, 0}, {3, 0}}, {0, 1}), Region::lit);
}

TEST(RegionOfDegenerate, APointLightOnTheBlockerSeesItselfAlone) {
  EXPECT_EQ(region_at({{0, 0}}, {0, 0}), Region::lit);
  EXPECT_EQ(region_at({{0, 0}}, {0.5, 0}), Region::umbra);
  EXPECT_EQ(region_at({{0, 0}}, {2, 0}), Region::umbra);
  EXPECT_EQ(region_at({{0, 0}}, {2, 1e-300}), Region::lit);
}

}  // namespace
}  // namespace gnomon::planar
