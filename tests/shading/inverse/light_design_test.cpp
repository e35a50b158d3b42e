#include "gnomon/light_design.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shading/inverse/conflict.h"
#include "shading/inverse/feasible_region.h"
#include "shading/inverse/goal_sets.h"
#include "tests/shading/inverse/design_cases.h"

namespace gnomon {
namespace {

using namespace test_support;
using testing::ElementsAre;

DesignObstacles one_blocker(const ConvexBlocker& blocker) {
  return {{{blocker}, {}}, {"shelf"}, {"shelf"}};
}

const ConvexPolygon shelf = ConvexPolygon::from_points({{12, -3, 12}, {18, -3, 12}, {18, 9, 12}, {12, 9, 12}});

DesignSubject desk() {
  return {{{0, 0, 0}, {12, 0, 0}, {12, 6, 0}, {0, 6, 0}},
          FacetFront{{Point3{0, 0, 0}, Point3{12, 0, 0}, Point3{12, 6, 0}}}};
}

/// A lamp that leaves a pillow dark, lights a desk, and is not mirrored in it.
Design lamp_over_a_desk(const DesignDomain& domain, double eye = -3) {
  Design design;
  design.domain = domain;
  design.goals = {{.name = "pillow", .want = Want::dark, .subjects = {{{{18, 3, 0}}, {}}}, .by = "shelf"},
                  {.name = "desk", .want = Want::lit, .subjects = {desk()}},
                  {.name = "page", .want = Want::no_reflection, .subjects = {desk()}, .eye = {eye, 3, 8}}};
  return design;
}

const DesignDomain track = {DomainShape::segment, {{0, 3, 24}, {24, 3, 24}}};
const DesignDomain ceiling = {DomainShape::polygon, {{0, -9, 24}, {24, -9, 24}, {24, 15, 24}, {0, 15, 24}}};
const DesignDomain room = {DomainShape::box, {{0, -9, 21}, {24, 15, 24}}};

TEST(LightDesign, PlacesALampOverADeskInTheMiddleOfAllItsPlaces) {
  const DesignResult result = solved_design(lamp_over_a_desk(track), one_blocker(shelf), {});
  EXPECT_EQ(result.status, DesignStatus::feasible);
  EXPECT_EQ(result.size.exact, "3");
  ASSERT_TRUE(result.answer);
  EXPECT_EQ(result.answer->position, (Point3{7.5, 3, 24}));
  EXPECT_EQ(result.answer->exact[0].exact, "15/2");
  EXPECT_EQ(result.answer->margin, 1.5);
  EXPECT_TRUE(result.answer->representable);
  for (const GoalOutcome& outcome : result.goals) EXPECT_TRUE(outcome.satisfied);
  EXPECT_EQ(result.goals[0].slack, 1.5);
  EXPECT_EQ(result.goals[1].slack, 4.5);
  EXPECT_EQ(result.goals[2].slack, 1.5);
}

TEST(LightDesign, MeasuresAllPlacesExactly) {
  EXPECT_EQ(solved_design(lamp_over_a_desk(ceiling), one_blocker(shelf), {}).size.exact, "72");
  const DesignResult result = solved_design(lamp_over_a_desk(room), one_blocker(shelf), {});
  EXPECT_EQ(result.size.exact, "927/8");
  EXPECT_EQ(result.dimension, 3);
}

TEST(LightDesign, TakesTheMiddleOfAllBallsThatAreLargest) {
  const DesignResult result = solved_design(lamp_over_a_desk(ceiling), one_blocker(shelf), {});
  EXPECT_EQ(result.answer->position, (Point3{7.5, 3, 24}));
  EXPECT_EQ(result.answer->margin, 1.5);
}

TEST(LightDesign, TellsWhichGoalsCollide) {
  const DesignResult result = solved_design(lamp_over_a_desk(ceiling, -2), one_blocker(shelf), {});
  EXPECT_EQ(result.status, DesignStatus::infeasible);
  ASSERT_TRUE(result.conflict);
  EXPECT_THAT(result.conflict->goals, ElementsAre(0, 2));
}

TEST(LightDesign, DecidesTheEndsOfTheTrackAsGrazingHides) {
  const Design design = lamp_over_a_desk(track);
  const auto goals_at = [&](double x) { return checked_design(design, one_blocker(shelf), {x, 3, 24}).goals; };
  EXPECT_TRUE(goals_at(6)[0].satisfied);   // grazing hides the pillow
  EXPECT_FALSE(goals_at(9)[2].satisfied);  // and grazing is seen in the desk
  EXPECT_TRUE(goals_at(12)[1].satisfied);  // of a receiver it has no measure
  EXPECT_FALSE(goals_at(5.9)[0].satisfied);
  EXPECT_TRUE(goals_at(8.9)[2].satisfied);
  EXPECT_FALSE(goals_at(12.1)[1].satisfied);
}

TEST(LightDesign, KeepsAMarginFromEveryBoundary) {
  Design design = lamp_over_a_desk(track);
  for (const auto& [margin, length] : {std::pair(0.5, "2"), {1.0, "1"}}) {
    design.margin = margin;
    EXPECT_EQ(solved_design(design, one_blocker(shelf), {}).size.exact, length);
  }
  design.margin = 1.75;
  EXPECT_EQ(solved_design(design, one_blocker(shelf), {}).status, DesignStatus::infeasible);
}

TEST(LightDesign, TakesTheNearestPlaceAndTheLargestCube) {
  DesignEffort effort;
  effort.choice = Choice::nearest;
  effort.near = Point3{0, 0, 24};
  const DesignResult nearest = solved_design(lamp_over_a_desk(ceiling), one_blocker(shelf), effort);
  EXPECT_EQ(nearest.answer->position, (Point3{6, 0, 24}));
  effort.near = Point3{7, 100, 30};
  EXPECT_EQ(solved_design(lamp_over_a_desk(ceiling), one_blocker(shelf), effort).answer->position, (Point3{7, 15, 24}));
  effort.choice = Choice::cube;
  const DesignResult cube = solved_design(lamp_over_a_desk(ceiling), one_blocker(shelf), effort);
  EXPECT_EQ(cube.answer->position, (Point3{7.5, 3, 24}));
  EXPECT_EQ(cube.answer->margin, 1.5);
}

/// Nobody can stand farther from all walls: tried on a lattice.
TEST(LightDesignAgreement, NoPlaceOfALatticeHasALargerMargin) {
  int tried = 0;
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    Dice dice(seed);
    const DesignCase c = drawn_position_case(dice, Numbers::large);
    const DesignResult result = solved_design(c.design, c.obstacles, {});
    if (result.status != DesignStatus::feasible || result.cells.size() != 1) continue;
    ++tried;
    const double margin = result.answer->margin;
    for (int k = 0; k < 400; ++k) {
      const Point3 p = {dice.draw(-64, 64) / 16.0, dice.draw(-64, 64) / 16.0, dice.draw(32, 128) / 16.0};
      const DesignResult there = checked_design(c.design, c.obstacles, p);
      double least = std::min({p.x + 4, 4 - p.x, p.y + 4, 4 - p.y, p.z - 2, 8 - p.z});
      for (const GoalOutcome& outcome : there.goals) least = std::min(least, outcome.slack.value_or(least));
      EXPECT_LE(least, margin * (1 + 1e-12)) << "seed " << seed << '\n' << told(c, p);
    }
  }
  EXPECT_GT(tried, 5);
}

TEST(LightDesignAgreement, NoFeasiblePlaceOfALatticeIsNearer) {
  int on_a_wall = 0;
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    Dice dice(seed);
    const DesignCase c = drawn_position_case(dice, Numbers::large);
    const Point3 near = {dice.draw(-40, 40) / 8.0, dice.draw(-40, 40) / 8.0, dice.draw(0, 80) / 8.0};
    DesignEffort effort;
    effort.choice = Choice::nearest;
    effort.near = near;
    const DesignResult result = solved_design(c.design, c.obstacles, effort);
    if (result.status != DesignStatus::feasible) continue;
    const auto square = [&](const Point3& p) {
      const Vector3<double> v = step(near, p);
      return dot(v, v);
    };
    const double nearest = square(result.answer->position);
    on_a_wall += nearest > 0 && square({near.x, near.y, std::clamp(near.z, 2.0, 8.0)}) != nearest ? 1 : 0;
    for (int k = 0; k < 300; ++k) {
      const Point3 p = {dice.draw(-32, 32) / 8.0, dice.draw(-32, 32) / 8.0, dice.draw(16, 64) / 8.0};
      EXPECT_FALSE(square(p) < nearest * (1 - 1e-12) && is_fulfilled(c, p)) << "seed " << seed << '\n' << told(c, p);
    }
  }
  EXPECT_GT(on_a_wall, 5);
}

/// The board's height above the window, by its depth: windows dark in summer, lit in winter.
DesignResult overhang(double depth, double most = 20) {
  Design design;
  design.variable = FreeVariable::blocker;
  design.blocker = "shelf";
  design.domain = {DomainShape::segment, {{0, 0, 0}, {0, 0, most}}};
  const DesignSubject window = {{{0, 0, 0}, {0, 0, 12}, {8, 0, 12}, {8, 0, 0}},
                                FacetFront{{Point3{0, 0, 0}, Point3{0, 0, 12}, Point3{8, 0, 12}}}};
  design.goals = {{.name = "summer", .want = Want::dark, .subjects = {window}, .light = DirectionalLight{{0, -1, -2}}},
                  {.name = "winter", .want = Want::lit, .subjects = {window}, .light = DirectionalLight{{0, -2, -1}}}};
  const auto board = ConvexPolygon::from_points({{0, 0, 12}, {8, 0, 12}, {8, depth, 12}, {0, depth, 12}});
  return solved_design(design, one_blocker(board), {});
}

TEST(LightDesign, HangsABoardThatShadesInSummerOnly) {
  const DesignResult result = overhang(9);
  EXPECT_EQ(result.status, DesignStatus::feasible);
  EXPECT_EQ(result.answer->exact[2].exact, "21/4");
  EXPECT_EQ(result.answer->margin, 0.75);
  EXPECT_EQ(result.size.exact, "3/2");
  EXPECT_THAT(result.goals, testing::Each(testing::Field(&GoalOutcome::satisfied, true)));
}

TEST(LightDesign, TellsOfASinglePlaceThatItIsFlat) {
  const DesignResult result = overhang(8);
  EXPECT_EQ(result.status, DesignStatus::flat);
  EXPECT_EQ(result.dimension, 0);
  EXPECT_EQ(result.answer->position.z, 4);
  EXPECT_THAT(result.goals, testing::Each(testing::Field(&GoalOutcome::satisfied, true)));
}

TEST(LightDesign, TellsThatABoardIsTooShort) {
  const DesignResult result = overhang(7);
  EXPECT_EQ(result.status, DesignStatus::infeasible);
  EXPECT_THAT(result.conflict->goals, ElementsAre(0, 1));
}

Design nails(std::array<Point3, 2> at) {
  Design design;
  design.goals = {{.name = "first", .want = Want::nail, .subjects = {{{at[0]}, {}}}, .by = "shelf", .element = 0},
                  {.name = "second", .want = Want::nail, .subjects = {{{at[1]}, {}}}, .by = "shelf", .element = 1}};
  return design;
}

TEST(LightDesign, TwoNailsMeetAsInFigure535) {
  const auto triangle = ConvexPolygon::from_points({{0, 0, 1}, {3, 0, 1}, {1, 2, 1}});
  const DesignResult result = solved_design(nails({Point3{0, 0, 0}, Point3{4, 0, 0}}), one_blocker(triangle), {});
  EXPECT_EQ(result.status, DesignStatus::feasible);
  EXPECT_EQ(result.dimension, 0);
  EXPECT_EQ(result.answer->position, (Point3{0, 0, 4}));
}

TEST(LightDesign, NailsThatMeetBelowTheFloorOrNowhereAreInfeasible) {
  const auto wide = ConvexPolygon::from_points({{0, 0, 1}, {5, 0, 1}, {1, 2, 1}});
  EXPECT_EQ(solved_design(nails({Point3{0, 0, 0}, Point3{4, 0, 0}}), one_blocker(wide), {}).status,
            DesignStatus::infeasible);
  EXPECT_EQ(solved_design(nails({Point3{0, 0, 0}, Point3{5, 0, 0}}), one_blocker(wide), {}).status,
            DesignStatus::infeasible);
}

TEST(LightDesign, ThreeEdgesThroughPointsMakeOnePosition) {
  const Point3 light = {1, 2, 9};
  const auto triangle = ConvexPolygon::from_points({{0, 0, 3}, {6, 0, 3}, {0, 6, 3}});
  Design design;
  for (std::uint32_t e = 0; e < 3; ++e) {
    // Where the middle of the edge throws its shadow on z = 0: the light's distance is half again the edge's.
    const Point3 a = triangle.points()[e], b = triangle.points()[(e + 1) % 3];
    const Point3 m = {(a.x + b.x) / 2, (a.y + b.y) / 2, 3};
    const Point3 q = {light.x + 1.5 * (m.x - light.x), light.y + 1.5 * (m.y - light.y), 0};
    design.goals.push_back(
        {.name = "e" + std::to_string(e), .want = Want::edge, .subjects = {{{q}, {}}}, .by = "shelf", .element = e});
  }
  const DesignResult result = solved_design(design, one_blocker(triangle), {});
  EXPECT_EQ(result.status, DesignStatus::feasible);
  EXPECT_EQ(result.answer->position, light);
}

TEST(LightDesignDegenerate, APointInsideASolidIsNeverLit) {
  const auto solid = ConvexSolid::hull_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}});
  Design design;
  design.domain = room;
  design.goals = {{.name = "core", .want = Want::lit, .subjects = {{{{0.5, 0.5, 0.5}}, {}}}}};
  const DesignResult lit = solved_design(design, one_blocker(solid), {});
  EXPECT_EQ(lit.status, DesignStatus::infeasible);
  EXPECT_THAT(lit.conflict->goals, ElementsAre(0));
  EXPECT_THAT(lit.remarks, ElementsAre(testing::HasSubstr("solid \"shelf\"")));
  design.goals[0].want = Want::dark;
  EXPECT_EQ(solved_design(design, one_blocker(solid), {}).size.exact, "1728");
}

TEST(LightDesignDegenerate, AWallSeenEdgeOnMovesTheAnswerOutOfItsPlane) {
  // The point lies in the wall's plane, and so does the middle of the room.
  const auto wall = ConvexPolygon::from_points({{-1, 0, 1}, {1, 0, 1}, {1, 0, 2}, {-1, 0, 2}});
  Design design;
  design.domain = {DomainShape::box, {{-3, -3, 4}, {3, 3, 10}}};
  design.goals = {{.name = "p", .want = Want::lit, .subjects = {{{{0, 0, 0}}, {}}}}};
  const DesignResult result = solved_design(design, one_blocker(wall), {});
  EXPECT_EQ(result.status, DesignStatus::feasible);
  EXPECT_EQ(result.size.exact, "216");
  EXPECT_NE(result.answer->position.y, 0);
  EXPECT_TRUE(result.goals[0].satisfied);
}

TEST(LightDesignDegenerate, WithoutGoalsTheWholeDomainIsFeasible) {
  Design design;
  design.domain = room;
  const DesignResult result = solved_design(design, one_blocker(shelf), {});
  EXPECT_EQ(result.size.exact, "1728");
  EXPECT_EQ(result.answer->margin, 1.5);
}

TEST(LightDesignDegenerate, UnboundedRegionsHaveANearestPlaceButNoCentre) {
  Design design = lamp_over_a_desk({});
  EXPECT_THROW(solved_design(design, one_blocker(shelf), {}), DesignError);
  DesignEffort effort;
  effort.choice = Choice::nearest;
  effort.near = Point3{7.5, 3, 24};
  const DesignResult result = solved_design(design, one_blocker(shelf), effort);
  EXPECT_FALSE(result.bounded);
  EXPECT_EQ(result.answer->position, (Point3{7.5, 3, 24}));
}

TEST(LightDesignDegenerate, OppositeGoalsAtOnePointCollide) {
  Design design;
  design.domain = room;
  const DesignSubject p = {{{18, 3, 0}}, {}};
  design.goals = {{.name = "a", .want = Want::lit, .subjects = {p}},
                  {.name = "b", .want = Want::lit, .subjects = {{{{0, 0, 0}}, {}}}},
                  {.name = "c", .want = Want::dark, .subjects = {p}}};
  const DesignResult result = solved_design(design, one_blocker(shelf), {});
  EXPECT_EQ(result.status, DesignStatus::infeasible);
  EXPECT_THAT(result.conflict->goals, ElementsAre(0, 2));
}

TEST(LightDesignDegenerate, RepeatedGoalsChangeNothing) {
  Design design = lamp_over_a_desk(room);
  design.goals.push_back(design.goals[0]);
  design.goals.push_back(design.goals[2]);
  EXPECT_EQ(solved_design(design, one_blocker(shelf), {}).size.exact, "927/8");
}

TEST(LightDesign, FindsTheDirectionsThatHideAPoint) {
  Design design;
  design.variable = FreeVariable::direction;
  design.domain = {DomainShape::directions, {}};
  design.goals = {{.name = "p", .want = Want::dark, .subjects = {{{{15, 3, 0}}, {}}}}};
  const DesignResult result = solved_design(design, one_blocker(shelf), {});
  EXPECT_EQ(result.status, DesignStatus::feasible);
  EXPECT_TRUE(result.goals[0].satisfied);
  EXPECT_EQ(result.answer->position.x, 0);
  EXPECT_EQ(result.answer->position.y, 0);
  design.goals.push_back({.name = "q", .want = Want::lit, .subjects = {{{{15, 4, 0}}, {}}}});
  const DesignResult both = solved_design(design, one_blocker(shelf), {});
  EXPECT_EQ(both.status, DesignStatus::feasible);
  for (const GoalOutcome& outcome : both.goals) EXPECT_TRUE(outcome.satisfied);
}

TEST(LightDesignDegenerate, ALampInTheShelfsPlaneIsHiddenFromNothing) {
  Design design;
  design.domain = {DomainShape::segment, {{13, 3, 12}, {17, 3, 12}}};
  design.goals = {{.name = "pillow", .want = Want::lit, .subjects = {{{{15, 3, 0}}, {}}}}};
  EXPECT_EQ(solved_design(design, one_blocker(shelf), {}).size.exact, "4");
  design.goals[0].want = Want::dark;
  EXPECT_EQ(solved_design(design, one_blocker(shelf), {}).status, DesignStatus::infeasible);
}

TEST(LightDesign, HangsTheLampWhereTheDesksDarkestCornerIsBrightest) {
  Design design = lamp_over_a_desk(track);
  DesignEffort effort;
  effort.choice = Choice::brightest;
  const DesignResult result = solved_design(design, one_blocker(shelf), effort);
  EXPECT_EQ(result.answer->exact[0].exact, "6");
  const double brightest = 24 / (621 * std::sqrt(621));
  design.goals.push_back({.name = "enough", .want = Want::irradiance, .subjects = {desk()}});
  design.goals.back().at_least = brightest * (1 - 1e-12);
  const DesignResult enough = solved_design(design, one_blocker(shelf), {});
  EXPECT_EQ(enough.answer->position.x, 6);
  EXPECT_NEAR(enough.goals[3].irradiance->value, brightest, 1e-15 * brightest);
  design.goals.back().at_least = brightest * (1 + 1e-6);
  const DesignResult dark = solved_design(design, one_blocker(shelf), {});
  EXPECT_EQ(dark.status, DesignStatus::infeasible);
  EXPECT_THAT(dark.conflict->goals, testing::Contains(3U));
  design.goals.back().at_least = 0.001;
  EXPECT_EQ(solved_design(design, one_blocker(shelf), {}).answer->position.x, 7.5);
}

TEST(LightDesign, PutsALightOnTheNormalAndTheMirrorRay) {
  Design design;
  design.domain = ceiling;
  const DesignSubject spot = {{{4, 3, 0}}, FacingNormal{{0, 0, 1}}};
  design.goals = {{.name = "peak", .want = Want::diffuse_peak, .subjects = {spot}}};
  EXPECT_EQ(solved_design(design, one_blocker(shelf), {}).answer->position, (Point3{4, 3, 24}));
  design.goals = {
      {.name = "shine", .want = Want::highlight, .subjects = {spot}, .eye = {0, 1, 8}, .contour = Point3{5, 3, 0}}};
  const DesignResult result = solved_design(design, one_blocker(shelf), {});
  EXPECT_EQ(result.answer->position, (Point3{16, 9, 24}));
  // (R · L)^n = 1/2, in doubles: R mirrors the way to the eye.
  const double r[3] = {5, 2, 8}, l[3] = {11, 6, 24};
  const double cosine = (r[0] * l[0] + r[1] * l[1] + r[2] * l[2]) / std::sqrt((25.0 + 4 + 64) * (121 + 36 + 576));
  const double exponent = std::log(0.5) / std::log(cosine);
  EXPECT_NEAR(result.goals[0].exponent->value, exponent, 1e-9 * exponent);
  EXPECT_LE(result.goals[0].exponent->error_bound, 1e-12 * exponent);
  design.variable = FreeVariable::direction;
  design.domain = {DomainShape::directions, {}};
  const Point3 towards = solved_design(design, one_blocker(shelf), {}).answer->position;
  EXPECT_EQ(towards.x / towards.z, 0.5);
  EXPECT_EQ(towards.y / towards.z, 0.25);
}

/// A lamp of half side s behind a shelf of half side 1 half way up: dark to s = 2, and lit from nowhere on.
TEST(LightDesign, ScalesALampUntilItIsSeen) {
  const auto board = ConvexPolygon::from_points({{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}});
  Design design;
  design.variable = FreeVariable::scale;
  design.centre = {0, 0, 4};
  design.light = AreaLight{ConvexPolygon::from_points({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}})};
  design.domain = {DomainShape::segment, {{0.25, 0, 0}, {8, 0, 0}}};
  design.goals = {{.name = "p", .want = Want::dark, .subjects = {{{{0, 0, 0}}, {}}}}};
  const DesignResult dark = solved_design(design, one_blocker(board), {});
  EXPECT_EQ(dark.size.exact, "7/4");
  EXPECT_EQ(dark.goals[0].region, "umbra");
  design.goals[0].want = Want::lit;
  EXPECT_EQ(solved_design(design, one_blocker(board), {}).status, DesignStatus::infeasible);
  design.goals[0].subjects[0].points[0] = {5, 0, 0};  // half of the line to the light: seen while s <= 3
  const DesignResult lit = solved_design(design, one_blocker(board), {});
  EXPECT_EQ(lit.size.exact, "11/4");
  design.goals[0].want = Want::penumbra;
  EXPECT_EQ(solved_design(design, one_blocker(board), {}).size.exact, "5");
}

TEST(LightDesign, SaysWhereReceiversMayBeDarkBehindBlockersTogether) {
  Design design;
  design.domain = room;
  design.goals = {{.name = "desk", .want = Want::dark, .subjects = {desk()}}};
  DesignObstacles two = one_blocker(ConvexPolygon::from_points({{-9, -9, 12}, {5, -9, 12}, {5, 15, 12}, {-9, 15, 12}}));
  EXPECT_EQ(solved_design(design, two, {}).status, DesignStatus::infeasible);
  two.obstacles.blockers.emplace_back(
      ConvexPolygon::from_points({{5, -9, 12}, {20, -9, 12}, {20, 15, 12}, {5, 15, 12}}));
  two.parts = two.elements = {"shelf", "other"};
  EXPECT_EQ(solved_design(design, two, {}).status, DesignStatus::sufficient_only);
}

}  // namespace

namespace inverse {
namespace {

/// All subsets of goals, the definition of a minimal conflict.
TEST(ConflictAgreement, IsMinimalAmongAllSubsets) {
  int conflicts = 0, with_multipliers = 0;
  std::array<int, 8> sizes{};
  for (std::uint32_t seed = 1; seed <= (GNOMON_LONG ? 2000 : 150); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    DesignCase c;
    c.obstacles = drawn_obstacles(dice, Numbers::large, 3);
    c.design.domain = {DomainShape::box, {{-9, -9, 4}, {9, 9, 12}}};
    const bool is_convex = dice.once_in(2);
    for (int k = 0; k < 5; ++k) {
      DesignGoal goal = drawn_goal(dice, Numbers::small, k, c.obstacles);
      goal.subjects = {{{drawn_point(dice, Numbers::small, -1, 0)}, {}}};
      if (is_convex) {
        goal.want = Want::dark;
        goal.by = dice.one_of(c.obstacles.elements);
      }
      c.design.goals.push_back(goal);
    }
    DesignSpace space;
    std::vector<GoalSets> goals;
    for (std::uint32_t g = 0; g < 5; ++g) goals.push_back(goal_sets(space, c.design, g, c.obstacles));
    const auto is_feasible = [&](unsigned subset) {
      std::vector<GoalSets> some;
      for (unsigned g = 0; g < 5; ++g) {
        if (subset >> g & 1U) some.push_back(goals[g]);
      }
      return !feasible_cells(space, c.design.domain, some, {}).cells.empty();
    };
    if (is_feasible(31)) continue;
    ++conflicts;
    const DesignConflict found = conflict(space, c.design.domain, goals, 0);
    unsigned set = 0;
    for (const std::uint32_t g : found.goals) set |= 1U << g;
    EXPECT_FALSE(is_feasible(set));
    for (unsigned subset = 0; subset < 32; ++subset) {
      EXPECT_TRUE((subset & set) != subset || subset == set || is_feasible(subset));
    }
    ++sizes[found.goals.size()];
    with_multipliers += found.multipliers.empty() ? 0 : 1;
    EXPECT_LE(found.multipliers.size(), 4U);
    EXPECT_LE(found.goals.size(), is_convex ? 4U : 5U);
  }
  EXPECT_GT(conflicts, 30);
  EXPECT_GT(with_multipliers, 10);
  EXPECT_GT(sizes[2], 5);
}

/// Boards over a track, of which each forbids its piece: all goals are needed.
TEST(Conflict, OfLitGoalsMayNeedThemAll) {
  DesignCase c;
  for (int i = 0; i < 6; ++i) {
    const double x = 2 * i, y = 5 * (i + 1);
    c.obstacles.obstacles.blockers.emplace_back(ConvexPolygon::from_points(
        {{x + 0.5, y - 0.25, 1}, {x + 1.5, y - 0.25, 1}, {x + 1.5, y + 0.25, 1}, {x + 0.5, y + 0.25, 1}}));
    c.obstacles.parts.push_back("b" + std::to_string(i));
    c.design.goals.push_back(
        {.name = "g" + std::to_string(i), .want = Want::lit, .subjects = {{{{x + 1, 2 * y, 0}}, {}}}});
  }
  c.obstacles.elements = c.obstacles.parts;
  c.design.domain = {DomainShape::segment, {{0, 0, 2}, {12, 0, 2}}};
  const DesignResult result = solved_design(c.design, c.obstacles, {});
  EXPECT_EQ(result.status, DesignStatus::infeasible);
  EXPECT_EQ(result.conflict->goals.size(), 6U);
  for (int k = 0; k <= 120; ++k) EXPECT_FALSE(is_fulfilled(c, {k / 10.0, 0, 2})) << k;
}

}  // namespace
}  // namespace inverse
}  // namespace gnomon
