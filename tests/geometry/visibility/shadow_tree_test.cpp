#include "geometry/visibility/shadow_tree.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "geometry/numbers/rounding.h"
#include "geometry/visibility/patient_shadow_tree.h"
#include "gnomon/receiver_mesh.h"
#include "gnomon/visibility.h"
#include "tests/support/dice.h"

// That a tree tells of points what the definition says is law ST1.

namespace gnomon {
namespace {

using test_support::Dice;

/// Of polygons in a plane of equal heights.
Rational area(const std::vector<ExactPolygon>& pieces) {
  Rational doubled = 0;
  for (const ExactPolygon& piece : pieces) doubled += doubled_area(piece).z;
  return doubled / 2;
}

Point3 draw_place(Dice& dice, int reach, int low, int high) {
  const double x = dice.draw(-reach, reach), y = dice.draw(-reach, reach);
  return {x, y, 1.0 * dice.draw(low, high)};
}

std::vector<ConvexBlocker> draw_blockers(Dice& dice, int count, int low, int high) {
  std::vector<ConvexBlocker> blockers;
  while (static_cast<int>(blockers.size()) < count) {
    std::vector<Point3> points;
    for (int i = dice.once_in(3) ? 5 : 3; i > 0; --i) points.push_back(draw_place(dice, 4, low, high));
    if (points.size() == 3 && !ConvexPolygon::defect(points)) {
      blockers.emplace_back(ConvexPolygon::from_points(points));
    } else if (points.size() > 3) {
      try {
        blockers.emplace_back(ConvexSolid::hull_of(points));
      } catch (const std::exception&) {  // all in one plane
      }
    }
  }
  return blockers;
}

/// The areas that receivers are divided into by events, which share nothing with trees, as rational numbers.
TEST(ShadowTreeAgreement, PiecesOfAFloorHaveTheAreasOfItsRegionsExactly) {
  const ConvexPolygon floor = ConvexPolygon::from_points({{-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0}});
  int in_shadow = 0;
  EXPECT_TRUE(rc::check("areas agree", [&] {
    Dice dice;
    if (!dice.once_in(4)) return;
    const bool is_sun = dice.once_in(2);
    const Point3 lamp = draw_place(dice, 3, 7, 9);
    const Point3 way{1.0 * dice.draw(-2, 2), 1.0 * dice.draw(-2, 2), -3};
    const std::vector<ConvexBlocker> blockers = draw_blockers(dice, dice.draw(1, 5), 1, 6);
    const ShadowTree tree =
        is_sun ? ShadowTree(DirectionalLight{way}, blockers) : ShadowTree(PointLight{lamp}, blockers);
    const Light light = is_sun ? Light(DirectionalLight{way}) : Light(PointLight{lamp});
    const ShadowPieces pieces = tree.pieces(floor.points());
    const auto areas = receiver_division(light, blockers, std::vector{floor}).front().areas();
    const auto umbra = areas[static_cast<std::size_t>(ReceiverRegion::umbra)];
    in_shadow += pieces.shadow.empty() ? 0 : 1;
    RC_ASSERT(exact_number(area(pieces.shadow)).exact == umbra.exact);
    RC_ASSERT(area(pieces.shadow) + area(pieces.lit) == 1600);
  }));
  EXPECT_GT(in_shadow, 10);
}

/// With 30 blockers the tree is there after 3,000 questions.
TEST(ShadowTreeAgreement, AnswersOfManyQuestionsAreThoseOfTheExactLevelBeforeAndAfterItIsBuilt) {
  Dice dice(7);
  const std::vector<ConvexBlocker> blockers = draw_blockers(dice, 30, 1, 6);
  for (const Light& light : {Light(PointLight{{0.5, 0.25, 8}}), Light(DirectionalLight{{1, -2, -5}})}) {
    const Obstacles obstacles{blockers, {}};
    LightVisibility seen(light, PreparedObstacles(obstacles));
    for (int i = 0; i < 8000; ++i) {
      const Point3 p = draw_place(dice, 6, 0, 6);
      const Visibility bare = seen.at(p), received = seen.received({p, FacingNormal{{0, 1, 3}}});
      if (i % 16 > 0) continue;
      EXPECT_EQ(name(bare.region), name(exact_visibility(light, obstacles, p).region)) << i;
      EXPECT_EQ(name(received.region), name(exact_received(light, obstacles, {p, FacingNormal{{0, 1, 3}}}).region))
          << i;
    }
  }
}

TEST(ShadowTree, IsGrownOnceEnoughWasAsked) {
  Dice dice(7);
  const std::vector<ConvexBlocker> blockers = draw_blockers(dice, 30, 1, 6);
  PatientShadowTree patient(PointLight{{0, 0, 9}}, blockers);
  EXPECT_EQ(patient.after(2999), nullptr);
  const ShadowTree* tree = patient.after(1);
  ASSERT_NE(tree, nullptr);
  EXPECT_EQ(patient.after(1), tree);
  PatientShadowTree of_few(PointLight{{0, 0, 9}}, std::span(blockers).first(2));
  EXPECT_EQ(of_few.after(1'000'000), nullptr);
}

TEST(ShadowTree, KeepsOfTwoBoardsTheNearerOne) {
  const auto square = [](double half, double z) {
    return ConvexBlocker(
        ConvexPolygon::from_points({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}));
  };
  const ShadowTree near_alone(PointLight{{0, 0, 9}}, std::vector{square(2, 5)});
  const ShadowTree both(PointLight{{0, 0, 9}}, std::vector{square(1, 3), square(2, 5)});
  EXPECT_EQ(both.node_count(), near_alone.node_count()) << "the lower one lies wholly in the other's shadow";
  EXPECT_EQ(both.node_count(), 9u) << "four planes";
  EXPECT_EQ(both.height(), 5u);
  EXPECT_EQ(both.region_from({0.5, 0.25, 4}), Region::umbra);
  EXPECT_EQ(both.region_from({0.5, 0.25, 6}), Region::lit);
  EXPECT_EQ(both.tests({0.5, 0.25, 6}), 5u);
}

TEST(ShadowTreeDegenerate, LeavesOpenWhatGrazesOrTouches) {
  const std::vector<ConvexBlocker> board{ConvexPolygon::from_points({{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}})};
  const ShadowTree tree(DirectionalLight{{0, 0, -1}}, board);
  EXPECT_FALSE(tree.region_from({1, 0, 0})) << "under an edge";
  EXPECT_FALSE(tree.region_from({0, 0, 2})) << "on the board";
  const std::vector<ConvexBlocker> wall{ConvexPolygon::from_points({{-1, 0, 2}, {1, 0, 2}, {1, 0, 4}, {-1, 0, 4}})};
  EXPECT_FALSE(ShadowTree(DirectionalLight{{0, 0, -1}}, wall).region_from({0, 0, 0})) << "under a wall seen edge-on";
  EXPECT_EQ(ShadowTree(DirectionalLight{{0, 0, -1}}, wall).region_from({0, 1, 0}), Region::lit);
  const std::vector<ConvexBlocker> solid{ConvexSolid::hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})};
  EXPECT_FALSE(ShadowTree(PointLight{{0.1, 0.1, 0.1}}, solid).region_from({5, 5, 5})) << "the light is inside";
  EXPECT_FALSE(ShadowTree(PointLight{{0, 0, 9}}, {}).region_from({0, 0, 9}));
  EXPECT_FALSE(tree.region_from({1e31, 0, 0}));
}

}  // namespace
}  // namespace gnomon
