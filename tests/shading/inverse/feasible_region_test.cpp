#include "shading/inverse/feasible_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "shading/inverse/goal_sets.h"
#include "shading/inverse/lengths.h"
#include "tests/shading/inverse/design_cases.h"

namespace gnomon::inverse {
namespace {

using namespace test_support;

constexpr int cases_drawn = GNOMON_LONG ? 5000 : 400;
constexpr std::uint32_t first_seed = 27;

enum class Place { outside, boundary, inside };

/// Where a point lies of a cell, worked out from its planes.
Place place_of(DesignSpace& space, const Cell& cell, CornerId point) {
  Place place = Place::inside;
  for (const Corner& corner : cell.corners) {
    for (const CellPlane plane : corner.planes) {
      const int side = space.cells.side(plane, point);
      const bool within = lies(space.cells, cell, plane, PlaneSide::within);
      const bool beyond = lies(space.cells, cell, plane, PlaneSide::beyond);
      if (within && beyond) {
        if (side != 0) return Place::outside;
      } else if (within ? side > 0 : side < 0) {
        return Place::outside;
      } else if (side == 0) {
        place = Place::boundary;
      }
    }
  }
  return place;
}

/// What a case's region says of a point: the best place of all cells.
struct CaseRegion {
  DesignSpace space;
  std::vector<GoalSets> goals;
  FeasibleCells found;
  bool is_exact = true;
  CellPlane planes = 0;  ///< of goals

  explicit CaseRegion(const DesignCase& c) {
    for (std::uint32_t g = 0; g < c.design.goals.size(); ++g)
      goals.push_back(goal_sets(space, c.design, g, c.obstacles));
    planes = static_cast<CellPlane>(space.cells.plane_count());
    for (const GoalSets& goal : goals) is_exact = is_exact && !is_only_sufficient(space, c.design.domain, goal);
    found = feasible_cells(space, c.design.domain, goals, {});
  }

  Place place(const Point3& p) {
    const CornerId point = space.cells.add_corner(whole_point(p));
    Place best = Place::outside;
    for (const Cell& cell : found.cells) best = std::max(best, place_of(space, cell, point));
    return best;
  }

  /// True on a boundary of a goal: positions there may be good without a neighbour that is, and belong to no cell.
  bool is_grazing(const Point3& p) {
    const CornerId point = space.cells.add_corner(whole_point(p));
    for (CellPlane plane = 0; plane < planes; ++plane) {
      if (space.cells.side(plane, point) == 0) return true;
    }
    return false;
  }
};

/// True if the light, or a goal's point, lies in the plane of a flat blocker: seen edge-on that hides nothing that has
/// a measure, and such positions have no neighbours that are as good.
bool is_edge_on(const DesignCase& c, const Point3& position) {
  const bool is_moved = c.design.variable == FreeVariable::blocker;
  for (std::size_t b = 0; b < c.obstacles.parts.size(); ++b) {
    const auto points = points_of(c.obstacles.obstacles.blockers[b]);
    const ExactPlane plane = plane_through(exact(points[0]), exact(points[1]), exact(points[2]));
    if (!is_moved && plane.height(exact(position)) == 0) return true;
    for (const DesignGoal& goal : c.design.goals) {
      const ExactVector q = exact(goal.subjects[0].points[0]);
      if (is_moved && plane.height(q - exact(position)) == 0) return true;
    }
  }
  return false;
}

struct Tally {
  int inside = 0, outside = 0, boundary = 0, exact_cases = 0, empty = 0, flat = 0;

  void print(const char* name) const {
    std::cout << name << ": " << inside << " points inside, " << outside << " outside, " << boundary
              << " on boundaries; " << exact_cases << " exact cases, " << empty << " without a region, " << flat
              << " flat\n";
  }
};

/// Inside a cell every goal is fulfilled; where every goal is fulfilled there is a cell.
void expect_forward(const DesignCase& c, Dice& dice, int points, Tally& tally, const std::vector<Point3>& more = {}) {
  CaseRegion region(c);
  tally.exact_cases += region.is_exact ? 1 : 0;
  tally.empty += region.found.cells.empty() ? 1 : 0;
  tally.flat += region.found.is_flat && !region.found.cells.empty() ? 1 : 0;
  std::vector<Point3> tried = more;
  for (int k = 0; k < points; ++k) {
    tried.push_back({dice.draw(-16, 16) / 4.0, dice.draw(-16, 16) / 4.0, dice.draw(8, 32) / 4.0});
  }
  for (const Cell& cell : region.found.cells) {
    const ExactVector p = coordinates(middle(region.space.cells, cell));
    tried.push_back({static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
  }
  for (const Point3& p : tried) {
    const Place place = region.place(p);
    const bool is_good = is_fulfilled(c, p);
    const bool is_flat = region.found.is_flat;
    if (place == Place::inside && !is_flat) {
      ++tally.inside;
      ASSERT_TRUE(is_good) << told(c, p);
    }
    if (place == Place::outside && region.is_exact && !is_flat && !region.is_grazing(p) && !is_edge_on(c, p)) {
      ++tally.outside;
      ASSERT_FALSE(is_good) << told(c, p);
    }
    if (place == Place::boundary) ++tally.boundary;
  }
}

TEST(FeasibleRegionAgreement, HoldsExactlyThePositionsThatFulfilAllGoalsForward) {
  for (const Numbers numbers : {Numbers::large, Numbers::small}) {
    Tally tally;
    for (std::uint32_t seed = first_seed; seed < first_seed + cases_drawn; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Dice dice(seed);
      expect_forward(drawn_position_case(dice, numbers), dice, 25, tally);
      if (HasFatalFailure()) return;
    }
    tally.print(numbers == Numbers::large ? "large numbers" : "small numbers");
    EXPECT_GT(tally.inside, cases_drawn);
    EXPECT_GT(tally.outside, cases_drawn);
  }
}

/// Goals made of what a light does that stands somewhere: it lies in its own region.
TEST(FeasibleRegionProperty, HoldsTheLightThatGoalsWereMadeOf) {
  int inside = 0;
  for (std::uint32_t seed = first_seed; seed < first_seed + cases_drawn; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    DesignCase c = drawn_position_case(dice, dice.once_in(2) ? Numbers::large : Numbers::small);
    const Point3 light = {dice.draw(-15, 15) / 4.0 + 1 / 64.0, dice.draw(-15, 15) / 4.0 + 1 / 128.0,
                          dice.draw(9, 31) / 4.0};
    for (DesignGoal& goal : c.design.goals) {
      goal.subjects.resize(1, goal.subjects[0]);
      goal.subjects[0] = {{drawn_point(dice, Numbers::large, -1, 2)}, {}};
      DesignCase alone = c;
      alone.design.goals = {goal};
      alone.design.goals[0].want = Want::lit;
      goal.want = is_fulfilled(alone, light) ? Want::lit : Want::dark;
    }
    CaseRegion region(c);
    EXPECT_NE(region.place(light), Place::outside) << told(c, light);
    inside += region.place(light) == Place::inside ? 1 : 0;
  }
  EXPECT_GT(inside, cases_drawn / 2);
}

TEST(FeasibleRegionAgreement, HoldsExactlyTheShiftsOfALightWithSize) {
  Tally tally;
  int penumbrae = 0;
  for (std::uint32_t seed = first_seed; seed < first_seed + cases_drawn; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    DesignCase c;
    const Numbers numbers = dice.once_in(2) ? Numbers::large : Numbers::small;
    c.obstacles = drawn_obstacles(dice, numbers, dice.draw(1, 2));
    c.design.domain = {DomainShape::box, {{-4, -4, 2}, {4, 4, 8}}};
    c.design.variable = FreeVariable::translation;
    const double a = dice.draw(1, 6) / 4.0;
    if (dice.once_in(3)) {
      c.design.light = LinearLight{{-a, 0, 0}, {0, 0.25, 0.5}};
    } else {
      c.design.light = AreaLight{ConvexPolygon::from_points({{0, 0, 0}, {0, a, 0}, {a, 0, 0}}), dice.once_in(2)};
    }
    for (int k = 0; k < dice.draw(1, 2); ++k) {
      DesignGoal goal;
      goal.name = "g" + std::to_string(k);
      goal.want = dice.one_of(std::array{Want::dark, Want::lit, Want::shadow, Want::penumbra});
      goal.subjects = {{{drawn_point(dice, numbers, -1, 0)}, {}}};
      if (goal.want == Want::penumbra) goal.by = "b0";
      penumbrae += goal.want == Want::penumbra ? 1 : 0;
      c.design.goals.push_back(goal);
    }
    expect_forward(c, dice, 20, tally);
    if (HasFatalFailure()) return;
  }
  tally.print("shifts of lights");
  EXPECT_GT(tally.inside, cases_drawn);
  EXPECT_GT(penumbrae, cases_drawn / 10);
}

TEST(FeasibleRegionAgreement, HoldsExactlyTheShiftsOfABlocker) {
  Tally tally;
  for (std::uint32_t seed = first_seed; seed < first_seed + cases_drawn; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    DesignCase c;
    const Numbers numbers = dice.once_in(2) ? Numbers::large : Numbers::small;
    c.obstacles = drawn_obstacles(dice, numbers, dice.draw(1, 2));
    c.design.domain = {DomainShape::box, {{-4, -4, 2}, {4, 4, 8}}};
    c.design.variable = FreeVariable::blocker;
    c.design.blocker = "b0";
    for (int k = 0; k < dice.draw(1, 2); ++k) {
      DesignGoal goal = drawn_goal(dice, numbers, k, c.obstacles);
      goal.by = "b0";
      goal.subjects = {{{drawn_point(dice, numbers, -1, 0)}, {}}};
      const Point3 p = drawn_point(dice, numbers, 12, 14);
      if (dice.once_in(3)) {
        goal.light = PointLight{p};
      } else if (dice.once_in(2)) {
        goal.light = DirectionalLight{{p.x, p.y, -p.z}};
      } else {
        goal.light = AreaLight{ConvexPolygon::from_points({p, {p.x, p.y + 1, p.z}, {p.x + 1, p.y, p.z}})};
      }
      c.design.goals.push_back(goal);
    }
    expect_forward(c, dice, 20, tally);
    if (HasFatalFailure()) return;
  }
  tally.print("shifts of blockers");
  EXPECT_GT(tally.inside, cases_drawn / 2);
}

TEST(FeasibleRegionAgreement, HoldsExactlyTheScalesOfALight) {
  int inside = 0, outside = 0;
  for (std::uint32_t seed = first_seed; seed < first_seed + cases_drawn; ++seed) {
    Dice dice(seed);
    DesignCase c;
    const Numbers numbers = dice.once_in(2) ? Numbers::large : Numbers::small;
    c.obstacles = drawn_obstacles(dice, numbers, dice.draw(1, 2));
    c.design.variable = FreeVariable::scale;
    const Point3 p = drawn_point(dice, numbers, 6, 8);
    c.design.centre = {p.x + dice.draw(-1, 1), p.y + dice.draw(-1, 1), p.z + dice.draw(-1, 1)};
    c.design.light = dice.once_in(3)
                         ? Light(LinearLight{p, {p.x + 1, p.y + 2, p.z + 1}})
                         : AreaLight{ConvexPolygon::from_points({p, {p.x, p.y + 1, p.z}, {p.x + 1, p.y, p.z}})};
    c.design.domain = {DomainShape::segment, {{0.25, 0, 0}, {8, 0, 0}}};
    DesignGoal goal;
    goal.name = "g";
    goal.want = dice.one_of(std::array{Want::dark, Want::lit, Want::shadow, Want::penumbra});
    goal.subjects = {{{drawn_point(dice, numbers, -1, 0)}, {}}};
    goal.by = "b0";
    c.design.goals = {goal};
    CaseRegion region(c);
    for (int k = 2; k <= 64 && !region.found.is_flat; ++k) {
      const Point3 scale = {k / 8.0, 0, 0};
      const Place place = region.place(scale);
      inside += place == Place::inside ? 1 : 0;
      outside += place == Place::outside ? 1 : 0;
      ASSERT_TRUE(place != Place::inside || region.is_grazing(scale) || is_fulfilled(c, scale))
          << "seed " << seed << '\n'
          << told(c, scale);
      if (place == Place::outside && !region.is_grazing(scale)) {
        ASSERT_FALSE(is_fulfilled(c, scale)) << "seed " << seed << '\n' << told(c, scale);
      }
    }
  }
  EXPECT_GT(inside, cases_drawn);
  EXPECT_GT(outside, cases_drawn);
}

TEST(FeasibleRegion, TellsJointDarknessOfAMovedLight) {
  DesignCase c;
  c.obstacles.obstacles.blockers = {ConvexPolygon::from_points({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}),
                                    ConvexPolygon::from_points({{1, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}})};
  c.obstacles.parts = c.obstacles.elements = {"left", "right"};
  c.design.variable = FreeVariable::translation;
  c.design.light = AreaLight{ConvexPolygon::from_points({{0, 0, 2}, {0, 1, 2}, {3, 1, 2}, {3, 0, 2}}), true};
  c.design.domain = {DomainShape::polygon, {{-6, -6, 0}, {6, -6, 0}, {6, 6, 0}, {-6, 6, 0}}};
  DesignGoal goal;
  goal.name = "eye";
  goal.want = Want::dark;
  goal.subjects = {{{{0, 0, 0}}, {}}};
  c.design.goals = {goal};
  const DesignResult result = solved_design(c.design, c.obstacles, {});
  EXPECT_EQ(result.status, DesignStatus::feasible);
  EXPECT_EQ(result.size.exact, "1");
  for (int i = -12; i <= 12; ++i) {
    for (int j = -12; j <= 12; ++j) {
      const Point3 t = {i / 4.0, j / 4.0, 0};
      const bool is_in = t.x >= 0 && t.x <= 1 && t.y >= 0 && t.y <= 1;
      EXPECT_EQ(is_fulfilled(c, t), is_in) << t.x << ' ' << t.y;
    }
  }
}

TEST(FeasibleRegionProperty, CellsHaveNoCommonInterior) {
  for (std::uint32_t seed = first_seed; seed < first_seed + 50; ++seed) {
    Dice dice(seed);
    const DesignCase c = drawn_position_case(dice, Numbers::large);
    CaseRegion region(c);
    if (region.found.is_flat) continue;
    const auto& cells = region.found.cells;
    for (std::size_t i = 0; i < std::min<std::size_t>(cells.size(), 12); ++i) {
      const CornerId point = region.space.cells.add_corner(middle(region.space.cells, cells[i]));
      for (std::size_t j = 0; j < cells.size(); ++j) {
        EXPECT_EQ(place_of(region.space, cells[j], point) == Place::inside, i == j) << "seed " << seed;
      }
    }
  }
}

TEST(FeasibleRegionAgreement, VolumesInDoublesAreThoseInRationalNumbers) {
  int compared = 0;
  for (std::uint32_t seed = first_seed; seed < first_seed + 40; ++seed) {
    Dice dice(seed);
    CaseRegion region(drawn_position_case(dice, Numbers::large));
    if (region.found.is_flat) continue;
    for (const Cell& cell : region.found.cells) {
      const double near = near_volume(region.space.cells, cell);
      EXPECT_NEAR(near * near, static_cast<double>(squared_size(region.space.cells, cell)), 1e-14 * near * near);
      ++compared;
    }
  }
  EXPECT_GT(compared, 20);
}

TEST(FeasibleRegionProperty, OneMoreGoalNeverEnlargesIt) {
  for (std::uint32_t seed = first_seed; seed < first_seed + 60; ++seed) {
    Dice dice(seed);
    DesignCase c = drawn_position_case(dice, Numbers::small);
    const DesignResult all = solved_design(c.design, c.obstacles, {});
    c.design.goals.pop_back();
    const DesignResult fewer = solved_design(c.design, c.obstacles, {});
    const bool is_exact = all.status != DesignStatus::sufficient_only;
    if (!is_exact) continue;
    EXPECT_LE(all.dimension, fewer.dimension) << "seed " << seed;
    if (all.dimension == 3) {
      EXPECT_LE(all.size.nearest, fewer.size.nearest * (1 + 1e-12)) << "seed " << seed;
    }
  }
}

TEST(FeasibleRegionProperty, DoublesWithTheSceneAndMovesWithIt) {
  const auto placed = [](const Point3& p, double scale) {
    return Point3{scale * p.x + 3, scale * p.y - 5, scale * p.z + 2};
  };
  for (std::uint32_t seed = first_seed; seed < first_seed + 40; ++seed) {
    Dice dice(seed);
    DesignCase c = drawn_position_case(dice, Numbers::large);
    for (DesignGoal& goal : c.design.goals) goal.subjects = {{{drawn_point(dice, Numbers::large, -1, 1)}, {}}};
    DesignCase moved = c;
    for (ConvexBlocker& b : moved.obstacles.obstacles.blockers) {
      std::vector<Point3> points;
      for (const Point3& p : points_of(b)) points.push_back(placed(p, 2));
      if (b.index() == 0)
        b = ConvexPolygon::from_points(points);
      else
        b = ConvexSolid::hull_of(points);
    }
    for (DesignGoal& goal : moved.design.goals) goal.subjects[0].points[0] = placed(goal.subjects[0].points[0], 2);
    for (Point3& p : moved.design.domain.vertices) p = placed(p, 2);
    const DesignResult here = solved_design(c.design, c.obstacles, {});
    const DesignResult there = solved_design(moved.design, moved.obstacles, {});
    EXPECT_EQ(here.status, there.status) << "seed " << seed;
    EXPECT_EQ(here.cells.size(), there.cells.size()) << "seed " << seed;
    EXPECT_NEAR(8 * here.size.nearest, there.size.nearest, 1e-12 * there.size.nearest) << "seed " << seed;
  }
}

TEST(FeasibleRegionDegenerate, MoreCellsThanAllowedAreRefused) {
  Dice dice(1);
  const DesignCase c = drawn_position_case(dice, Numbers::large);
  DesignEffort effort;
  effort.most_cells = 1;
  DesignCase lit = c;
  lit.design.goals.resize(1);
  lit.design.goals[0] = {.name = "p", .want = Want::lit, .subjects = {{{{0.5, 0.5, 0}}, {}}}};
  lit.obstacles.obstacles.blockers = {ConvexPolygon::from_points({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}})};
  lit.obstacles.parts = lit.obstacles.elements = {"b0"};
  EXPECT_THROW(solved_design(lit.design, lit.obstacles, effort), DesignError);
  effort.most_cells = 100;
  EXPECT_EQ(solved_design(lit.design, lit.obstacles, effort).status, DesignStatus::feasible);
}

}  // namespace
}  // namespace gnomon::inverse
