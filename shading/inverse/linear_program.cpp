#include "shading/inverse/linear_program.h"

#include <cmath>

#include "geometry/numbers/rounding.h"

namespace gnomon::inverse {
namespace {

bool is_below_zero(const Rational& x) {
  return x < 0;
}
bool is_below_zero(double x) {
  return x < -1e-9;
}
bool is_above_zero(const Rational& x) {
  return x > 0;
}
bool is_above_zero(double x) {
  return x > 1e-9;
}

/// The simplex method's tableau: columns of y, then one artificial column for each row, then the right side; the last
/// row has reduced costs.
template <class Number>
class Tableau {
 public:
  Tableau(std::vector<std::vector<Number>> rows, std::size_t columns)
      : rows_(std::move(rows)), columns_(columns), height_(rows_.size()), basis_(height_) {
    for (std::size_t i = 0; i < height_; ++i) basis_[i] = columns_ + i;
    rows_.emplace_back(columns_ + height_ + 1, Number(0));
  }

  const std::vector<std::size_t>& basis() const { return basis_; }
  const Number& right(std::size_t row) const { return rows_[row].back(); }
  const Number& reduced_cost(std::size_t column) const { return rows_.back()[column]; }
  const Number& last() const { return rows_.back().back(); }
  bool is_artificial(std::size_t column) const { return column >= columns_; }

  /// Reduced costs from costs: of y as given, of artificial columns `artificial`.
  void set_cost(const std::vector<Number>& cost, const Number& artificial) {
    std::vector<Number>& last = rows_.back();
    for (std::size_t k = 0; k < last.size(); ++k) last[k] = of(cost, artificial, k);
    for (std::size_t i = 0; i < height_; ++i) {
      const Number factor = of(cost, artificial, basis_[i]);
      if (factor == 0) continue;
      for (std::size_t k = 0; k < last.size(); ++k) last[k] -= factor * rows_[i][k];
    }
  }

  void pivot(std::size_t row, std::size_t column) {
    const Number inverse = Number(1) / rows_[row][column];
    for (Number& x : rows_[row]) x *= inverse;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Number factor = rows_[i][column];
      if (i == row || factor == 0) continue;
      for (std::size_t k = 0; k < rows_[i].size(); ++k) {
        if (rows_[row][k] != 0) rows_[i][k] -= factor * rows_[row][k];
      }
    }
    basis_[row] = column;
  }

  /// Returns: false if the cost has no least value.
  bool improve(std::size_t most_steps) {
    for (std::size_t step = 0; step < most_steps; ++step) {
      std::size_t column = 0;
      while (column < columns_ && !is_below_zero(rows_.back()[column])) ++column;
      if (column == columns_) return true;
      const std::optional<std::size_t> row = leaving(column);
      if (!row) return false;
      pivot(*row, column);
    }
    return true;
  }

  /// Brings artificial columns out of the basis where that can be.
  void expel_artificial() {
    for (std::size_t i = 0; i < height_; ++i) {
      if (!is_artificial(basis_[i])) continue;
      for (std::size_t k = 0; k < columns_; ++k) {
        if (rows_[i][k] != 0) {
          pivot(i, k);
          break;
        }
      }
    }
  }

  /// Pivots a column in, in a row that still has an artificial one, if the right side stays not negative in the end.
  void try_column(std::size_t column) {
    for (std::size_t i = 0; i < height_; ++i) {
      if (is_artificial(basis_[i]) && rows_[i][column] != 0) return pivot(i, column);
    }
  }

  bool is_feasible() const {
    for (std::size_t i = 0; i < height_; ++i) {
      if (is_below_zero(right(i))) return false;
    }
    return true;
  }

 private:
  Number of(const std::vector<Number>& cost, const Number& artificial, std::size_t k) const {
    if (k < columns_) return cost[k];
    return k < columns_ + height_ ? artificial : Number(0);
  }

  /// Bland's rule: of equal ratios the lowest column leaves.
  std::optional<std::size_t> leaving(std::size_t column) const {
    std::optional<std::size_t> best;
    Number least(0);
    for (std::size_t i = 0; i < height_; ++i) {
      if (!is_above_zero(rows_[i][column])) continue;
      const Number ratio = right(i) / rows_[i][column];
      if (!best || ratio < least || (ratio == least && basis_[i] < basis_[*best])) {
        best = i;
        least = ratio;
      }
    }
    return best;
  }

  std::vector<std::vector<Number>> rows_;
  std::size_t columns_, height_;
  std::vector<std::size_t> basis_;
};

/// The rows, turned so that the right side is not negative, with artificial columns.
template <class Number, class From>
Tableau<Number> first_tableau(const StandardProgram& program, const From& from) {
  const std::size_t n = program.columns.size(), m = program.right.size();
  std::vector<std::vector<Number>> rows(m, std::vector<Number>(n + m + 1, Number(0)));
  for (std::size_t i = 0; i < m; ++i) {
    const bool turned = program.right[i] < 0;
    for (std::size_t k = 0; k < n; ++k)
      rows[i][k] = from(turned ? Rational(-program.columns[k][i]) : program.columns[k][i]);
    rows[i][n + i] = Number(1);
    rows[i].back() = from(Rational(abs(program.right[i])));
  }
  return Tableau<Number>(std::move(rows), n);
}

/// The tableau that doubles take for the last.
Tableau<double> likely_tableau(const StandardProgram& program) {
  constexpr std::size_t most_steps = 1000;
  auto tableau = first_tableau<double>(program, nearest_double);
  std::vector<double> cost;
  for (const Rational& c : program.cost) cost.push_back(nearest_double(c));
  tableau.set_cost(std::vector<double>(cost.size(), 0), 1);
  tableau.improve(most_steps);
  tableau.set_cost(cost, 0);
  tableau.improve(most_steps);
  return tableau;
}

std::vector<std::size_t> likely_basis(const StandardProgram& program) {
  const Tableau<double> tableau = likely_tableau(program);
  std::vector<std::size_t> basis;
  for (const std::size_t column : tableau.basis()) {
    if (!tableau.is_artificial(column)) basis.push_back(column);
  }
  return basis;
}

std::vector<Rational> multipliers_of(const Tableau<Rational>& tableau, const StandardProgram& program,
                                     const Rational& artificial) {
  std::vector<Rational> result;
  for (std::size_t i = 0; i < program.right.size(); ++i) {
    const Rational y = artificial - tableau.reduced_cost(program.columns.size() + i);
    result.push_back(program.right[i] < 0 ? Rational(-y) : y);
  }
  return result;
}

}  // namespace

std::vector<double> rough_multipliers(const StandardProgram& program) {
  const Tableau<double> tableau = likely_tableau(program);
  std::vector<double> result;
  for (std::size_t i = 0; i < program.right.size(); ++i) {
    const double y = -tableau.reduced_cost(program.columns.size() + i);
    result.push_back(program.right[i] < 0 ? -y : y);
  }
  return result;
}

ProgramSolution solved_program(const StandardProgram& program) {
  constexpr std::size_t no_limit = ~std::size_t{0};
  const auto same = [](const Rational& x) { return x; };
  auto tableau = first_tableau<Rational>(program, same);
  for (const std::size_t column : likely_basis(program)) tableau.try_column(column);
  if (!tableau.is_feasible()) tableau = first_tableau<Rational>(program, same);
  ProgramSolution solution;
  tableau.set_cost(std::vector<Rational>(program.cost.size(), 0), 1);
  tableau.improve(no_limit);
  if (tableau.last() != 0) {
    solution.multipliers = multipliers_of(tableau, program, 1);
    return solution;
  }
  tableau.expel_artificial();
  tableau.set_cost(program.cost, 0);
  if (!tableau.improve(no_limit)) {
    solution.kind = ProgramSolution::Kind::unbounded;
    return solution;
  }
  solution.kind = ProgramSolution::Kind::optimal;
  solution.multipliers = multipliers_of(tableau, program, 0);
  solution.y.assign(program.columns.size(), 0);
  for (std::size_t i = 0; i < program.right.size(); ++i) {
    if (!tableau.is_artificial(tableau.basis()[i])) solution.y[tableau.basis()[i]] = tableau.right(i);
  }
  return solution;
}

}  // namespace gnomon::inverse
