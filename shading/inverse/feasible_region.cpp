#include "shading/inverse/feasible_region.h"

#include <algorithm>

#include "shading/inverse/lengths.h"

namespace gnomon::inverse {
namespace {

/// Splits cells by the sets of goals.
class Division {
 public:
  Division(DesignSpace& space, FlatParts flat, std::size_t most) : space_(space), flat_(flat), most_(most) {}

  void keep_on(std::vector<Cell>& cells, CellPlane plane) {
    std::vector<Cell> kept;
    for (const Cell& cell : cells) add(kept, section(space_.cells, cell, plane));
    cells = std::move(kept);
  }

  void keep_within(std::vector<Cell>& cells, const ConvexSet& set) {
    std::vector<Cell> kept;
    for (const Cell& cell : cells) add(kept, inside(cell, set));
    cells = std::move(kept);
  }

  /// Alternatives without common interior: each without those before.
  void keep_any(std::vector<Cell>& cells, const std::vector<ConvexSet>& sets) {
    std::vector<Cell> kept, rest = cells;
    for (const ConvexSet& set : sets) {
      for (const Cell& cell : rest) add(kept, inside(cell, set));
      remove(rest, set);
    }
    cells = std::move(kept);
  }

  void remove(std::vector<Cell>& cells, const ConvexSet& set) {
    std::vector<Cell> kept;
    for (const Cell& cell : cells) add_outside(kept, cell, set);
    cells = std::move(kept);
  }

 private:
  void add(std::vector<Cell>& cells, Cell cell) {
    if (cell.empty()) return;
    if (cells.size() >= most_) {
      throw DesignError("the feasible region falls into more than " + std::to_string(most_) +
                        " cells; --max-cells allows more, a smaller domain makes fewer");
    }
    cells.push_back(std::move(cell));
  }

  bool lies_in(const Cell& cell, CellPlane plane) const {
    return lies(space_.cells, cell, plane, PlaneSide::within) && lies(space_.cells, cell, plane, PlaneSide::beyond);
  }

  /// What lies in the plane itself is within where the plane belongs to the set, else beyond.
  Cell within(const Cell& cell, const Wall& wall) {
    Cell result = part(space_.cells, cell, wall.plane, PlaneSide::within, flat_);
    return !wall.is_closed && lies_in(result, wall.plane) ? Cell{} : result;
  }

  Cell beyond(const Cell& cell, const Wall& wall) {
    Cell result = part(space_.cells, cell, wall.plane, PlaneSide::beyond, flat_);
    return wall.is_closed && lies_in(result, wall.plane) ? Cell{} : result;
  }

  Cell inside(Cell cell, const ConvexSet& set) {
    for (const Wall& wall : set.walls) {
      if (cell.empty()) break;
      cell = within(cell, wall);
    }
    return cell;
  }

  /// A set in one plane takes nothing away that has an interior; but a cell on both sides of it is no cell any more in
  /// whose middle all is well.
  void add_sides(std::vector<Cell>& cells, const Cell& cell, const ConvexSet& set) {
    Cell across = section(space_.cells, cell, *set.flat);
    for (const Wall& wall : set.walls) {
      if (!across.empty()) across = part(space_.cells, across, wall.plane, PlaneSide::within, FlatParts::kept);
    }
    if (across.empty()) return add(cells, cell);
    add(cells, part(space_.cells, cell, *set.flat, PlaneSide::within, FlatParts::dropped));
    add(cells, part(space_.cells, cell, *set.flat, PlaneSide::beyond, FlatParts::dropped));
  }

  /// The pieces beyond the set's planes, one after the other; what meets the set nowhere stays whole.
  void add_outside(std::vector<Cell>& cells, const Cell& cell, const ConvexSet& set) {
    const auto is_beyond = [&](const Wall& wall) {
      return lies(space_.cells, cell, wall.plane, PlaneSide::beyond) &&
             !(wall.is_closed && lies(space_.cells, cell, wall.plane, PlaneSide::within));
    };
    if (flat_ == FlatParts::dropped && std::ranges::any_of(set.walls, is_beyond)) return add(cells, cell);
    if (flat_ == FlatParts::dropped && set.flat && !lies_in(cell, *set.flat)) return add_sides(cells, cell, set);
    Cell rest = cell;
    std::vector<Cell> pieces;
    for (const Wall& wall : set.walls) {
      pieces.push_back(beyond(rest, wall));
      rest = within(rest, wall);
      if (rest.empty()) {
        // Nothing is taken away: what has been split is whole.
        if (flat_ == FlatParts::dropped) return add(cells, cell);
        break;
      }
    }
    for (Cell& piece : pieces) add(cells, std::move(piece));
  }

  DesignSpace& space_;
  FlatParts flat_;
  std::size_t most_;
};

/// Pieces that are the same set of corners stand for one; those whose middle is no answer go.
std::vector<Cell> true_cells(DesignSpace& space, const std::vector<Cell>& cells, std::span<const GoalSets> goals) {
  std::vector<Cell> result;
  std::vector<Whole> middles;
  for (const Cell& cell : cells) {
    const Whole centre = middle(space.cells, cell);
    if (std::ranges::find(middles, centre) != middles.end()) continue;
    const CornerId point = space.cells.add_corner(centre);
    if (!std::ranges::all_of(goals, [&](const GoalSets& goal) { return holds(space, goal, point); })) continue;
    middles.push_back(centre);
    result.push_back(cell);
  }
  return result;
}

std::vector<Cell> divided(DesignSpace& space, std::vector<Cell> cells, std::span<const GoalSets> goals, FlatParts flat,
                          std::size_t most) {
  Division division(space, flat, most);
  for (const GoalSets& goal : goals) division.keep_within(cells, {goal.within});
  for (const GoalSets& goal : goals) {
    for (const auto& sets : goal.any) {
      if (sets.size() == 1) division.keep_within(cells, sets[0]);
    }
  }
  for (const GoalSets& goal : goals) {
    for (const auto& sets : goal.any) {
      if (sets.size() != 1) division.keep_any(cells, sets);
    }
  }
  for (const GoalSets& goal : goals) {
    for (const ConvexSet& set : goal.none) division.remove(cells, set);
  }
  return cells;
}

void shrink(DesignSpace& space, std::vector<Wall>& walls, const Extent& extent, const Rational& margin, int sign) {
  for (Wall& wall : walls) {
    const Whole plane = space.cells.plane(wall.plane);
    const Rational step = margin * extent.length_above(normal_of(plane));
    wall.plane = space.add(whole_plane(normal_of(plane), Rational(Rational(plane[3]) + sign * step)),
                           DesignWall(space.names[wall.plane]));
    wall.is_closed = sign > 0;
  }
}

/// The goals with every boundary a margin farther away, as it is measured in a cell of the domain.
std::vector<GoalSets> with_margin(DesignSpace& space, std::span<const GoalSets> goals, const Cell& cell,
                                  double margin) {
  std::vector<GoalSets> result(goals.begin(), goals.end());
  const Extent extent(space.cells, cell);
  for (GoalSets& goal : result) {
    shrink(space, goal.within, extent, Rational(margin), 1);
    for (auto& sets : goal.any) {
      for (ConvexSet& set : sets) shrink(space, set.walls, extent, Rational(margin), 1);
    }
    for (ConvexSet& set : goal.none) shrink(space, set.walls, extent, Rational(margin), -1);
  }
  return result;
}

std::vector<Cell> cells_in(DesignSpace& space, const Cell& domain, std::span<const GoalSets> goals, FlatParts flat,
                           const CellEffort& effort) {
  if (effort.margin == 0) return divided(space, {domain}, goals, flat, effort.most_cells);
  return divided(space, {domain}, with_margin(space, goals, domain, effort.margin), flat, effort.most_cells);
}

}  // namespace

FeasibleCells feasible_cells(DesignSpace& space, const DesignDomain& domain, std::span<const GoalSets> goals,
                             const CellEffort& effort) {
  std::vector<Cell> domains = domain_cells(space, domain);
  Division on(space, FlatParts::kept, effort.most_cells);
  for (const GoalSets& goal : goals) {
    for (const CellPlane plane : goal.on) on.keep_on(domains, plane);
  }
  FeasibleCells result;
  for (const FlatParts flat : {FlatParts::dropped, FlatParts::kept}) {
    for (const Cell& cell : domains) {
      std::vector<Cell> found = cells_in(space, cell, goals, flat, effort);
      if (flat == FlatParts::kept) found = true_cells(space, found, goals);
      std::ranges::move(found, std::back_inserter(result.cells));
      if (effort.stop_at_first && !result.cells.empty()) break;
    }
    result.is_flat = flat == FlatParts::kept;
    if (!result.cells.empty()) break;
  }
  return result;
}

bool is_only_sufficient(DesignSpace& space, const DesignDomain& domain, const GoalSets& goal) {
  constexpr std::size_t most_tried = 50;
  for (const auto& sets : goal.overlapping) {
    if (sets.size() > most_tried) return true;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      for (std::size_t j = i + 1; j < sets.size(); ++j) {
        GoalSets both;
        both.within = goal.within;
        both.any = {{sets[i]}, {sets[j]}};
        for (const Cell& cell : domain_cells(space, domain)) {
          if (!divided(space, {cell}, {&both, 1}, FlatParts::dropped, 1).empty()) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace gnomon::inverse
