#include "shading/inverse/conflict.h"

#include <algorithm>

#include "geometry/numbers/rounding.h"
#include "shading/inverse/feasible_region.h"
#include "shading/inverse/linear_program.h"

namespace gnomon::inverse {
namespace {

bool is_convex(const GoalSets& goal) {
  return goal.none.empty() && std::ranges::all_of(goal.any, [](const auto& sets) { return sets.size() == 1; });
}

/// The planes of a convex goal; those that it lies on turned both ways.
void add_planes(const GoalSets& goal, DesignSpace& space, std::vector<CellPlane>& planes) {
  for (const Wall& wall : goal.within) planes.push_back(wall.plane);
  for (const auto& sets : goal.any) {
    for (const Wall& wall : sets[0].walls) planes.push_back(wall.plane);
  }
  for (const CellPlane plane : goal.on) {
    const Whole p = space.cells.plane(plane);
    planes.push_back(plane);
    planes.push_back(
        space.add({Integer(-p[0]), Integer(-p[1]), Integer(-p[2]), Integer(-p[3])}, DesignWall(space.names[plane])));
  }
}

/// A domain's planes, turned so that it lies within; those that it lies on both ways.
void add_domain_planes(const Cell& cell, DesignSpace& space, std::vector<CellPlane>& planes) {
  std::vector<CellPlane> all;
  for (const Corner& corner : cell.corners) all.insert(all.end(), corner.planes.begin(), corner.planes.end());
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
  for (const CellPlane plane : all) {
    if (lies(space.cells, cell, plane, PlaneSide::within)) planes.push_back(plane);
    if (!lies(space.cells, cell, plane, PlaneSide::beyond)) continue;
    const Whole p = space.cells.plane(plane);
    planes.push_back(
        space.add({Integer(-p[0]), Integer(-p[1]), Integer(-p[2]), Integer(-p[3])}, DesignWall(space.names[plane])));
  }
}

void add_multipliers(DesignSpace& space, const DesignDomain& domain, const std::vector<GoalSets>& goals,
                     DesignConflict& result) {
  std::vector<CellPlane> planes;
  for (const GoalSets& goal : goals) add_planes(goal, space, planes);
  if (domain.shape != DomainShape::everywhere) {
    const std::vector<Cell> cells = domain_cells(space, domain);
    if (cells.size() != 1) return;
    add_domain_planes(cells[0], space, planes);
  }
  StandardProgram program;
  program.right = {0, 0, 0, 1};
  for (const CellPlane plane : planes) {
    const Whole& p = space.cells.plane(plane);
    program.columns.push_back({Rational(p[0]), Rational(p[1]), Rational(p[2]), Rational(p[3])});
    program.cost.push_back(0);
  }
  const ProgramSolution solution = solved_program(program);
  if (solution.kind != ProgramSolution::Kind::optimal) return;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (solution.y[k] == 0) continue;
    result.multipliers.push_back(exact_number(solution.y[k]).exact);
    result.planes.push_back(space.names[planes[k]]);
  }
}

}  // namespace

std::vector<GoalSets> chosen_goals(std::span<const GoalSets> goals, const std::vector<std::uint32_t>& numbers) {
  std::vector<GoalSets> result;
  for (const std::uint32_t k : numbers) result.push_back(goals[k]);
  return result;
}

DesignConflict conflict(DesignSpace& space, const DesignDomain& domain, std::span<const GoalSets> goals,
                        double margin) {
  const auto is_feasible = [&](const std::vector<std::uint32_t>& numbers) {
    const CellEffort effort{10000, true, margin};
    return !feasible_cells(space, domain, chosen_goals(goals, numbers), effort).cells.empty();
  };
  return conflict(space, domain, goals, is_feasible, margin == 0);
}

DesignConflict conflict(DesignSpace& space, const DesignDomain& domain, std::span<const GoalSets> goals,
                        const std::function<bool(const std::vector<std::uint32_t>&)>& is_feasible, bool is_polyhedral) {
  DesignConflict result;
  for (std::uint32_t k = 0; k < goals.size(); ++k) result.goals.push_back(k);
  for (std::size_t k = 0; k < result.goals.size();) {
    std::vector<std::uint32_t> fewer = result.goals;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
    if (is_feasible(fewer)) {
      ++k;
    } else {
      result.goals = std::move(fewer);
    }
  }
  const std::vector<GoalSets> needed = chosen_goals(goals, result.goals);
  if (is_polyhedral && std::ranges::all_of(needed, is_convex)) add_multipliers(space, domain, needed, result);
  return result;
}

}  // namespace gnomon::inverse
