#include "gnomon/light_design.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/numbers/rounding.h"
#include "shading/inverse/brightness.h"
#include "shading/inverse/choice.h"
#include "shading/inverse/conflict.h"
#include "shading/inverse/feasible_region.h"
#include "shading/inverse/goal_sets.h"
#include "shading/inverse/lengths.h"
#include "shading/inverse/outcome.h"
#include "shading/inverse/told_cells.h"

namespace gnomon {
namespace inverse {
namespace {

/// A design's planes and goals, made once.
struct PreparedDesign {
  DesignSpace space;
  std::vector<GoalSets> goals;

  PreparedDesign(const Design& design, const DesignObstacles& obstacles) {
    for (std::uint32_t g = 0; g < design.goals.size(); ++g) goals.push_back(goal_sets(space, design, g, obstacles));
  }
};

Point3 rounded(const ExactVector& p) {
  return {nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)};
}

/// The root of a rational number that is a square.
std::optional<Rational> exact_root(const Rational& square) {
  const Integer top = sqrt(numerator(square)), bottom = sqrt(denominator(square));
  const Rational root(top, bottom);
  if (root * root == square) return root;
  return std::nullopt;
}

/// The sum of the sizes of cells of one dimension; of many solid cells in doubles, right to 2^-49 of itself.
ExactNumber total_size(const DesignSpace& space, std::span<const Cell> cells) {
  constexpr std::size_t few = 8;
  if (cells.size() > few && dimension(space.cells, cells[0]) == 3) {
    double near = 0;
    for (const Cell& cell : cells) near += near_volume(space.cells, cell);
    return {near, ""};
  }
  Rational sum = 0;
  bool is_exact = true;
  for (const Cell& cell : cells) {
    const Rational square = squared_size(space.cells, cell);
    const std::optional<Rational> root = exact_root(square);
    is_exact = is_exact && root;
    sum += root ? *root : Rational(nearest_root(square));
  }
  ExactNumber size = exact_number(sum);
  if (!is_exact) size.exact.clear();
  return size;
}

/// The cell of the domain that a position is measured in: the first that holds it.
Cell domain_cell(DesignSpace& space, const DesignDomain& domain, const Whole& position, bool& is_inside) {
  const std::vector<Cell> cells = domain_cells(space, domain);
  const CornerId point = space.cells.add_corner(position);
  for (const Cell& cell : cells) {
    bool holds_it = true;
    for (const Corner& corner : cell.corners) {
      for (const CellPlane plane : corner.planes) {
        const int side = space.cells.side(plane, point);
        const bool within = lies(space.cells, cell, plane, PlaneSide::within);
        const bool beyond = lies(space.cells, cell, plane, PlaneSide::beyond);
        holds_it = holds_it && (side <= 0 || !within) && (side >= 0 || !beyond);
      }
    }
    if (holds_it) {
      is_inside = true;
      return cell;
    }
  }
  is_inside = false;
  return cells[0];
}

std::vector<GoalOutcome> outcomes(PreparedDesign& prepared, const Design& design, const DesignObstacles& obstacles,
                                  const Point3& position, const Cell& domain) {
  std::vector<GoalOutcome> result;
  for (std::uint32_t g = 0; g < design.goals.size(); ++g) {
    result.push_back(goal_outcome(prepared.space, design, g, prepared.goals[g], obstacles, position, domain));
  }
  return result;
}

Whole whole_position(const Design& design, const Point3& p) {
  return design.variable == FreeVariable::direction ? whole_direction(p) : whole_point(p);
}

/// The corners that some goals want bright: those of irradiance, or without these of light.
std::vector<BrightPoint> wanted_points(const Design& design, const std::vector<std::uint32_t>& goals, Want want) {
  std::vector<BrightPoint> points;
  for (const std::uint32_t g : goals) {
    const DesignGoal& goal = design.goals[g];
    if (goal.want != want || !goal.subjects[0].front) continue;
    std::ranges::move(bright_points(goal), std::back_inserter(points));
  }
  return points;
}

std::vector<std::uint32_t> all_goals(const Design& design) {
  std::vector<std::uint32_t> numbers(design.goals.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

/// Whether some goals leave a position that is bright enough for those of irradiance among them.
bool leaves_a_position(PreparedDesign& prepared, const Design& design, const std::vector<std::uint32_t>& goals) {
  const std::vector<BrightPoint> points = wanted_points(design, goals, Want::irradiance);
  const CellEffort effort{10000, points.empty(), design.margin};
  const FeasibleCells found =
      feasible_cells(prepared.space, design.domain, chosen_goals(prepared.goals, goals), effort);
  if (found.cells.empty() || points.empty()) return !found.cells.empty();
  return brightest_position(prepared.space, found.cells, points).most >= 1;
}

/// The brightest position of all, if that is the choice or the only way to be bright enough.
///
/// Returns: nothing if no position is bright enough.
std::optional<ChosenPoint> bright_point(PreparedDesign& prepared, const Design& design, const DesignEffort& effort,
                                        const FeasibleCells& found, DesignResult& result) {
  std::vector<BrightPoint> points = wanted_points(design, all_goals(design), Want::irradiance);
  const bool is_choice = effort.choice == Choice::brightest;
  if (is_choice && points.empty()) points = wanted_points(design, all_goals(design), Want::lit);
  if (points.empty()) {
    if (is_choice) throw DesignError("the brightest position needs a goal of light or irradiance on a receiver");
    return chosen_point(prepared.space, found.cells, effort.choice, effort.near);
  }
  const auto is_enough = [&](const ExactVector& p) {
    return std::ranges::all_of(points, [&](const BrightPoint& point) { return is_bright_enough(point, p); });
  };
  const bool is_wanted = !wanted_points(design, all_goals(design), Want::irradiance).empty();
  if (!is_choice) {
    const ChosenPoint point = chosen_point(prepared.space, found.cells, effort.choice, effort.near);
    if (is_enough(point.position)) return point;
  }
  const BrightestPosition best = brightest_position(prepared.space, found.cells, points);
  if (is_wanted && !is_enough(best.position)) {
    if (best.most >= 1) result.remarks.emplace_back("whether a position is bright enough was not decided");
    return std::nullopt;
  }
  if (!is_choice) result.remarks.emplace_back("the position that was to be chosen is too dark: this is the brightest");
  return ChosenPoint{best.position, 0};
}

/// Returns: false if no position is bright enough.
bool add_answer(PreparedDesign& prepared, const Design& design, const DesignObstacles& obstacles,
                const DesignEffort& effort, const FeasibleCells& found, DesignResult& result) {
  const bool is_direction = design.variable == FreeVariable::direction;
  if (!result.bounded && effort.choice != Choice::nearest && !is_direction) {
    throw DesignError(
        "the feasible region is unbounded and has no centre: a domain bounds it, --choose nearest needs none");
  }
  const std::optional<ChosenPoint> point = is_direction ? chosen_direction(prepared.space, found.cells)
                                                        : bright_point(prepared, design, effort, found, result);
  if (!point) return false;
  DesignAnswer answer;
  answer.position = rounded(point->position);
  for (std::size_t k = 0; k < 3; ++k) answer.exact[k] = exact_number(point->position[k]);
  answer.margin = nearest_double(point->radius);
  if (Rational(answer.margin) > point->radius) answer.margin = std::nextafter(answer.margin, 0);
  bool is_inside = false;
  const Cell domain = domain_cell(prepared.space, design.domain, whole_position(design, answer.position), is_inside);
  result.goals = outcomes(prepared, design, obstacles, answer.position, domain);
  answer.representable = is_inside && std::ranges::all_of(result.goals, &GoalOutcome::satisfied);
  result.answer = answer;
  return true;
}

/// The cells, and what is told of all together.
void add_region(PreparedDesign& prepared, const Design& design, const FeasibleCells& found, DesignResult& result) {
  const bool is_everywhere = design.domain.shape == DomainShape::everywhere;
  for (const Cell& cell : found.cells) {
    result.cells.push_back(told(prepared.space, cell, is_everywhere));
    result.dimension = std::max(result.dimension, dimension(prepared.space.cells, cell));
    const auto far = [&](const Corner& corner) { return is_far(prepared.space, corner); };
    if (is_everywhere && std::ranges::any_of(cell.corners, far)) result.bounded = false;
  }
  if (design.variable != FreeVariable::direction && result.bounded) {
    result.size = total_size(prepared.space, found.cells);
  } else {
    result.size.exact.clear();
  }
}

void name_solids(const Design& design, const std::vector<GoalSets>& goals, const DesignObstacles& obstacles,
                 DesignResult& result) {
  for (std::size_t g = 0; g < goals.size(); ++g) {
    const bool is_enclosed = std::ranges::any_of(goals[g].none, [](const ConvexSet& set) { return set.walls.empty(); });
    if (!is_enclosed) continue;
    for (const std::uint32_t part : parts_that_count(design.goals[g], obstacles)) {
      DesignSpace unused;
      const auto shadow =
          goal_sets(unused, design, static_cast<std::uint32_t>(g),
                    {{{obstacles.obstacles.blockers[part]}, {}}, {obstacles.parts[part]}, {obstacles.elements[part]}});
      if (std::ranges::none_of(shadow.none, [](const ConvexSet& set) { return set.walls.empty(); })) continue;
      result.remarks.push_back("goal \"" + design.goals[g].name + "\": its subject reaches into the solid \"" +
                               obstacles.parts[part] + "\", so nothing can light it");
    }
  }
}

}  // namespace
}  // namespace inverse

DesignObstacles design_obstacles(const SpaceScene& scene) {
  SceneBodies bodies = scene_bodies(scene);
  DesignObstacles result;
  for (const std::uint32_t id : bodies.blocker_ids) result.elements.push_back(scene.blockers[id].name);
  result.obstacles = std::move(bodies.obstacles);
  result.parts = std::move(bodies.names);
  return result;
}

DesignResult solved_design(const Design& design, const DesignObstacles& obstacles, const DesignEffort& effort) {
  using namespace inverse;
  PreparedDesign prepared(design, obstacles);
  const bool is_only_part = std::ranges::any_of(
      prepared.goals, [&](const GoalSets& goal) { return is_only_sufficient(prepared.space, design.domain, goal); });
  const FeasibleCells found =
      feasible_cells(prepared.space, design.domain, prepared.goals, {effort.most_cells, false, design.margin});
  DesignResult result;
  if (found.cells.empty()) {
    result.status = is_only_part ? DesignStatus::sufficient_only : DesignStatus::infeasible;
    name_solids(design, prepared.goals, obstacles, result);
    if (!is_only_part) result.conflict = conflict(prepared.space, design.domain, prepared.goals, design.margin);
    return result;
  }
  result.status = is_only_part    ? DesignStatus::sufficient_only
                  : found.is_flat ? DesignStatus::flat
                                  : DesignStatus::feasible;
  add_region(prepared, design, found, result);
  if (add_answer(prepared, design, obstacles, effort, found, result)) return result;
  result.status = DesignStatus::infeasible;
  const auto is_feasible = [&](const auto& goals) { return leaves_a_position(prepared, design, goals); };
  result.conflict = conflict(prepared.space, design.domain, prepared.goals, is_feasible, false);
  return result;
}

DesignResult checked_design(const Design& design, const DesignObstacles& obstacles, const Point3& position) {
  using namespace inverse;
  PreparedDesign prepared(design, obstacles);
  DesignResult result;
  bool is_inside = false;
  const Cell domain = domain_cell(prepared.space, design.domain, whole_position(design, position), is_inside);
  result.goals = outcomes(prepared, design, obstacles, position, domain);
  if (!is_inside) result.remarks.emplace_back("the position lies outside the domain");
  const bool is_good = is_inside && std::ranges::all_of(result.goals, &GoalOutcome::satisfied);
  result.status = is_good ? DesignStatus::feasible : DesignStatus::infeasible;
  DesignAnswer answer;
  answer.position = position;
  answer.exact = {exact_number(Rational(position.x)), exact_number(Rational(position.y)),
                  exact_number(Rational(position.z))};
  answer.representable = is_good;
  result.answer = answer;
  return result;
}

}  // namespace gnomon
