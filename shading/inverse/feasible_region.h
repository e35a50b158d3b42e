#pragma once

#include <span>

#include "gnomon/light_design.h"
#include "shading/inverse/design_space.h"

namespace gnomon::inverse {

/// Cells, and what kind of answer they are.
struct FeasibleCells {
  std::vector<Cell> cells;  ///< without common interior
  bool is_flat = false;     ///< none has the dimension of the domain
};

/// How cells are made.
struct CellEffort {
  std::size_t most_cells = 10000;
  bool stop_at_first = false;  ///< one cell will do
  double margin = 0;
};

/// The part of a domain that all goals leave.
///
/// Definition: what is convex is cut with once; of alternatives one after the other is taken, each without those
/// before;
///             what is forbidden splits each cell it meets into the pieces beyond its planes. If no piece has the
///             domain's dimension, flat pieces are sought whose middle fulfils the goals.
/// Throws:     DesignError for more cells than asked for.
FeasibleCells feasible_cells(DesignSpace& space, const DesignDomain& domain, std::span<const GoalSets> goals,
                             const CellEffort& effort);
inline FeasibleCells feasible_cells(DesignSpace& space, const DesignDomain& domain,
                                    std::initializer_list<GoalSets> goals, const CellEffort& effort) {
  return feasible_cells(space, domain, std::span(goals.begin(), goals.size()), effort);
}

/// True if more than what `any` says may fulfil a goal somewhere in the domain.
bool is_only_sufficient(DesignSpace& space, const DesignDomain& domain, const GoalSets& goal);

}  // namespace gnomon::inverse
