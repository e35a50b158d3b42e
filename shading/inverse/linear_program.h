#pragma once

#include <optional>
#include <vector>

#include "geometry/numbers/kernel.h"

namespace gnomon::inverse {

/// A linear program in standard form: the least cost · y with Σ_k columns[k] y_k = right, y >= 0.
struct StandardProgram {
  std::vector<std::vector<Rational>> columns;  ///< each as long as `right`
  std::vector<Rational> right;
  std::vector<Rational> cost;
};

struct ProgramSolution {
  enum class Kind { optimal, infeasible, unbounded };
  Kind kind = Kind::infeasible;
  std::vector<Rational> y;
  /// One for each row: Σ_i multipliers_i columns[k]_i <= cost_k for all k, and Σ multipliers_i right_i is the least
  /// cost. Of an infeasible program a certificate instead: the same with cost 0, and a sum above 0.
  std::vector<Rational> multipliers;
};

/// Exactness: rational arithmetic throughout. The basis is sought in doubles first; what that finds is only where exact
///            work begins.
/// Method:    the simplex method with Bland's rule, which ends always.
ProgramSolution solved_program(const StandardProgram& program);

/// The multipliers as doubles find them, right to nothing in particular: a place where exact work may begin.
std::vector<double> rough_multipliers(const StandardProgram& program);

}  // namespace gnomon::inverse
