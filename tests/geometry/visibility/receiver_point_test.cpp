#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "apps/proof/laws/draw.h"
#include "geometry/numbers/rounding.h"
#include "gnomon/visibility.h"
#include "tests/geometry/visibility/receiver_oracle.h"

namespace gnomon {
namespace {

using laws::BlockerKind;
using laws::Domain;
using laws::LightKind;
using laws::VisibilityCase;
using test_support::draw_receiver;
using test_support::expected_received;
using test_support::ExpectedReceived;

const std::vector<LightKind> lights_of_receivers = {LightKind::point, LightKind::direction, LightKind::segment,
                                                    LightKind::polygon, LightKind::rounded_polygon};
const std::vector<BlockerKind> blockers_of_receivers = {BlockerKind::polygon, BlockerKind::solid};

bool is_flat_light(const Light& light) {
  const auto* area = std::get_if<AreaLight>(&light);
  return !area || area->polygon.is_flat();
}

void log_receiver(const VisibilityCase& drawn, const ReceiverPoint& receiver) {
  const auto* facing = std::get_if<FacingNormal>(&receiver.front);
  const Point3 n = facing ? facing->normal : std::get<FacetFront>(receiver.front).corners[0];
  RC_LOG() << laws::description(drawn) << (facing ? "normal " : "facet from ") << n.x << ' ' << n.y << ' ' << n.z;
}

void check_receiver_exactly(Domain domain) {
  const VisibilityCase drawn = *laws::visibility_cases(domain, {lights_of_receivers, blockers_of_receivers, 3});
  const ReceiverPoint receiver = draw_receiver(drawn);
  const ExpectedReceived want = expected_received(drawn, receiver);
  const Visibility got = exact_received(drawn.light, {drawn.blockers, {}}, receiver);
  log_receiver(drawn, receiver);
  RC_ASSERT(name(got.region) == name(want.region));
  if (!is_flat_light(drawn.light)) return;
  RC_ASSERT(got.before_receiver == nearest_double(want.before));
  RC_ASSERT(std::fabs(got.fraction - nearest_double(want.fraction)) <= got.error_bound + 0x1p-53 * got.fraction);
  if (got.region == Region::lit) RC_ASSERT(got.fraction == got.before_receiver);
}

RC_GTEST_PROP(ReceiverPointAgreement, TheExactLevelIsTheLimitFromTheFront, ()) {
  check_receiver_exactly(Domain::random);
}

RC_GTEST_PROP(ReceiverPointAgreement, TheExactLevelIsTheLimitFromTheFrontNearDegeneracy, ()) {
  check_receiver_exactly(Domain::near_degenerate);
}

/// Whatever the fast levels say of a receiver's point, the exact level says too.
void check_receiver_levels(Domain domain) {
  int fast = 0;
  int asked = 0;
  EXPECT_TRUE(rc::check("levels agree", [&] {
    const VisibilityCase drawn = *laws::visibility_cases(domain, {lights_of_receivers, blockers_of_receivers, 4});
    const ReceiverPoint receiver = draw_receiver(drawn);
    LightVisibility both(drawn.light, PreparedObstacles({drawn.blockers, {}}));
    const Visibility got = both.received(receiver);
    ++asked;
    fast += both.exact_answers() == 0 ? 1 : 0;
    const Visibility want = exact_received(drawn.light, {drawn.blockers, {}}, receiver);
    log_receiver(drawn, receiver);
    RC_ASSERT(name(got.region) == name(want.region));
    RC_ASSERT(std::fabs(got.fraction - want.fraction) <= got.error_bound + want.error_bound);
    RC_ASSERT(got.before_receiver == want.before_receiver);
  }));
  EXPECT_GE(fast, asked / 3) << "of " << asked;
}

TEST(ReceiverPointAgreement, LevelsAgreeOnSmallIntegers) {
  check_receiver_levels(Domain::random);
}

TEST(ReceiverPointAgreement, LevelsAgreeNearDegeneracy) {
  check_receiver_levels(Domain::near_degenerate);
}

// Positions by name. The lamp is the square [-1, 1]^2 at height 4 that shines downward.

Light lamp_overhead() {
  return AreaLight{ConvexPolygon::from_points({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}}), false};
}

ConvexPolygon level_square(double half, double z) {
  return ConvexPolygon::from_points({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
}

Visibility received_at(const Light& light, const std::vector<ConvexBlocker>& blockers, const Point3& p,
                       const Point3& normal) {
  LightVisibility visibility(light, PreparedObstacles({blockers, {}}));
  return visibility.received({p, FacingNormal{normal}});
}

TEST(ReceiverPoint, CountsOfALampOnlyWhatLiesBeforeIt) {
  const Visibility sideways = received_at(lamp_overhead(), {}, {0, 0, 0}, {1, 0, 0});
  EXPECT_EQ(sideways, (Visibility{Region::lit, 0.5, 0x1p-54, 0.5}));
  EXPECT_EQ(received_at(lamp_overhead(), {}, {0, 0, 0}, {0, 0, 1}), (Visibility{Region::lit, 1, 0, 1}));
  EXPECT_EQ(received_at(lamp_overhead(), {}, {0, 0, 0}, {0, 0, -1}), (Visibility{Region::unlit, 0, 0, 0}));
  // The whole lamp lies before the receiver, but shows its back.
  EXPECT_EQ(received_at(lamp_overhead(), {}, {0, 0, 5}, {0, 0, -1}), (Visibility{Region::unlit, 0, 0, 1}));
}

TEST(ReceiverPoint, IsInUmbraWhereAllThatItCouldReceiveIsHidden) {
  // Hides the half of the lamp that lies before the first point, and the other for the second.
  const ConvexPolygon shutter = ConvexPolygon::from_points({{0, -9, 2}, {9, -9, 2}, {9, 9, 2}, {0, 9, 2}});
  EXPECT_EQ(received_at(lamp_overhead(), {shutter}, {0, 0, 0}, {1, 0, 0}).region, Region::umbra);
  EXPECT_EQ(received_at(lamp_overhead(), {shutter}, {0, 0, 0}, {-1, 0, 0}).region, Region::lit);
  const Visibility some = received_at(lamp_overhead(), {shutter}, {0.25, 0, 0}, {1, 0, 1});
  EXPECT_EQ(some.region, Region::penumbra);
  EXPECT_NEAR(some.fraction, 0.375, some.error_bound);
  EXPECT_EQ(some.before_receiver, 1);
}

TEST(ReceiverPoint, OnAFlatBlockerReceivesFromItsFrontAlone) {
  EXPECT_EQ(received_at(lamp_overhead(), {level_square(2, 1)}, {0, 0, 1}, {0, 0, 1}).region, Region::lit);
  // A tilted front still looks from above the blocker, which hides what lies behind it.
  const Light below = AreaLight{level_square(1, -2), true};
  EXPECT_EQ(received_at(below, {level_square(2, 1)}, {0, 0, 1}, {9, 0, 1}).region, Region::umbra);
  EXPECT_EQ(received_at(below, {level_square(2, 1)}, {0, 0, 1}, {9, 0, -1}).region, Region::lit);
}

TEST(ReceiverPoint, OnASolidFacingInwardIsInUmbra) {
  const ConvexSolid solid = ConvexSolid::hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_EQ(received_at(lamp_overhead(), {solid}, {0, 0.25, 0.25}, {1, 0, 0}).region, Region::umbra);
  EXPECT_EQ(received_at(lamp_overhead(), {solid}, {0, 0.25, 0.25}, {-1, 0, 0}).region, Region::lit);
}

TEST(ReceiverPoint, ASunBelowTheHorizonGivesNothing) {
  const Light sun = DirectionalLight{{1, 0, 0.25}};
  EXPECT_EQ(received_at(sun, {}, {0, 0, 0}, {0, 0, 1}).region, Region::unlit);
  EXPECT_EQ(received_at(DirectionalLight{{1, 0, 0}}, {}, {0, 0, 0}, {0, 0, 1}).region, Region::unlit);
  EXPECT_EQ(received_at(sun, {}, {0, 0, 0}, {0, 0, -1}).region, Region::lit);
}

TEST(ReceiverPoint, OfAFacetIsNotHiddenByTheFacetWhateverWasRounded) {
  const std::array<Point3, 3> corners = {{{0, 0, 0}, {1, 0, 0.3}, {0, 1, 0.1}}};
  const ConvexPolygon facet = ConvexPolygon::from_points({corners.begin(), corners.end()});
  const Point3 middle{1.0 / 3, 1.0 / 3, 0.4 / 3};
  for (const double off : {-1e-15, 0.0, 1e-15}) {
    const ReceiverPoint p{{middle.x, middle.y, middle.z + off}, FacetFront{corners}};
    LightVisibility visibility(lamp_overhead(), PreparedObstacles({{facet}, {}}));
    EXPECT_EQ(visibility.received(p).region, Region::lit) << off;
  }
}

/// A tent of four triangles, and what it encloses.
Obstacles leaning_tent() {
  const ClosedSurface surface{{{0, 0, 0}, {1, 0, 0.1}, {0.1, 1, 0}, {0.2, 0.3, 1}},
                              {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}}};
  Obstacles obstacles{{}, {surface}};
  for (const auto& [a, b, c] : surface.triangles) {
    obstacles.blockers.push_back(
        ConvexPolygon::from_points({surface.vertices[a], surface.vertices[b], surface.vertices[c]}));
  }
  return obstacles;
}

TEST(RestingPoint, IsNotHiddenByTheFacetUnderItOnWhicheverSideRoundingPutsIt) {
  const PreparedObstacles obstacles(leaning_tent());
  const auto& corners = obstacles.obstacles().enclosures[0].vertices;
  const Point3 a = corners[1], b = corners[2], c = corners[3];
  const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Point3 normal{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  LightVisibility visibility(PointLight{{3, 4, 5}}, obstacles);
  int hidden = 0;
  for (int i = 1; i < 20; ++i) {
    for (int k = 1; i + k < 20; ++k) {
      const double s = i / 20.0, t = k / 20.0;
      const Point3 p{a.x + s * u.x + t * v.x, a.y + s * u.y + t * v.y, a.z + s * u.z + t * v.z};
      EXPECT_EQ(visibility.received(resting_point(obstacles, p, normal)).region, Region::lit) << i << ' ' << k;
      const Region bare = visibility.at(p).region;
      hidden += bare == Region::umbra ? 1 : 0;
      EXPECT_TRUE(bare != Region::umbra || is_within_rounding(obstacles, p));
    }
  }
  EXPECT_GT(hidden, 20) << "as bare points some are hidden by the facet that they were computed on";
}

TEST(RestingPoint, IsStillHiddenByWhatStandsOnTheFacet) {
  const ConvexPolygon floor = level_square(2, 1);
  const ConvexPolygon wall = ConvexPolygon::from_points({{0, -1, 1}, {0, 1, 1}, {0, 1, 3}, {0, -1, 3}});
  const PreparedObstacles obstacles({{floor, wall}, {}});
  LightVisibility visibility(PointLight{{1, 0, 2}}, obstacles);
  const double below = 1 - 0x1p-53;  // an ulp under the floor
  const ReceiverPoint p = resting_point(obstacles, {-0.5, 0, below}, {0, 0, 1});
  EXPECT_EQ(p.under, std::vector<std::uint32_t>{0});
  EXPECT_EQ(visibility.received(p).region, Region::umbra);
  EXPECT_EQ(visibility.received(resting_point(obstacles, {0.5, 0, below}, {0, 0, 1})).region, Region::lit);
  // At the foot of the wall nothing but the floor lies under the point.
  EXPECT_EQ(resting_point(obstacles, {1e-17, 0, 1}, {0, 0, 1}).under, std::vector<std::uint32_t>{0});
}

TEST(RestingPoint, FarAboveTheFacetIsNoneAndWithinRoundingOfNothing) {
  const PreparedObstacles obstacles({{level_square(2, 1)}, {}});
  for (const double away : {1e-12, -1e-12, 0.5}) {
    EXPECT_TRUE(resting_point(obstacles, {0, 0, 1 + away}, {0, 0, 1}).under.empty()) << away;
    EXPECT_FALSE(is_within_rounding(obstacles, {0, 0, 1 + away})) << away;
  }
  EXPECT_FALSE(is_within_rounding(obstacles, {0, 0, 1})) << "it lies on it";
  EXPECT_TRUE(is_within_rounding(obstacles, {0, 0, 1 + 0x1p-52}));
}

}  // namespace
}  // namespace gnomon
