#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/numbers/rounding.h"
#include "gnomon/paint_fit.h"
#include "shading/inverse/linear_program.h"

namespace gnomon {
namespace {

using inverse::ProgramSolution, inverse::StandardProgram;

using ExactRow = std::vector<Rational>;

/// The normal equations of some rows.
struct NormalEquations {
  std::vector<ExactRow> gram;  ///< AᵀA
  ExactRow right;              ///< Aᵀb
  Rational square = 0;         ///< bᵀb

  NormalEquations(std::span<const FitRow> rows, std::uint32_t unknowns) : gram(unknowns, ExactRow(unknowns, 0)) {
    right.assign(unknowns, 0);
    for (const FitRow& row : rows) {
      const Rational wanted(row.wanted);
      square += wanted * wanted;
      for (std::uint32_t i = 0; i < unknowns; ++i) {
        right[i] += Rational(row.columns[i]) * wanted;
        for (std::uint32_t j = 0; j < unknowns; ++j) gram[i][j] += Rational(row.columns[i]) * Rational(row.columns[j]);
      }
    }
  }

  /// Half the slope of the cost in each unknown.
  Rational slope(std::uint32_t i, const ExactRow& x) const {
    Rational sum = -right[i];
    for (std::size_t j = 0; j < x.size(); ++j) sum += gram[i][j] * x[j];
    return sum;
  }

  Rational cost(const ExactRow& x) const {
    Rational sum = square;
    for (std::uint32_t i = 0; i < x.size(); ++i) sum += x[i] * (slope(i, x) - right[i]);
    return sum;
  }

  /// The free unknowns of least cost, others as they are; those that are not determined stay, too.
  ExactRow best(const std::vector<std::uint32_t>& free, ExactRow x) const {
    std::vector<ExactRow> system;
    for (const std::uint32_t i : free) {
      ExactRow row;
      Rational rest = right[i];
      for (const std::uint32_t j : free) row.push_back(gram[i][j]);
      for (std::uint32_t j = 0; j < x.size(); ++j) {
        if (std::ranges::find(free, j) == free.end()) rest -= gram[i][j] * x[j];
      }
      row.push_back(rest);
      system.push_back(std::move(row));
    }
    eliminate(system, free.size());
    for (std::size_t k = 0; k < free.size(); ++k) {
      const auto pivot = std::ranges::find_if(system, [&](const ExactRow& row) { return is_first(row, k); });
      x[free[k]] = pivot == system.end() ? Rational(0) : pivot->back();
    }
    return x;
  }

 private:
  static bool is_first(const ExactRow& row, std::size_t column) {
    const auto found = std::ranges::find_if(row, [](const Rational& v) { return v != 0; });
    return static_cast<std::size_t>(found - row.begin()) == column;
  }

  /// Gauss and Jordan: each pivot 1, and alone in its column.
  static void eliminate(std::vector<ExactRow>& system, std::size_t columns) {
    std::size_t next = 0;
    for (std::size_t k = 0; k < columns && next < system.size(); ++k) {
      const auto found = std::find_if(system.begin() + static_cast<std::ptrdiff_t>(next), system.end(),
                                      [&](const ExactRow& row) { return row[k] != 0; });
      if (found == system.end()) continue;
      std::iter_swap(found, system.begin() + static_cast<std::ptrdiff_t>(next));
      const Rational inverse = 1 / system[next][k];
      for (Rational& v : system[next]) v *= inverse;
      for (std::size_t i = 0; i < system.size(); ++i) {
        const Rational factor = system[i][k];
        if (i == next || factor == 0) continue;
        for (std::size_t j = 0; j < system[i].size(); ++j) system[i][j] -= factor * system[next][j];
      }
      ++next;
    }
  }
};

/// Every unknown free or at one of its bounds: of all that are possible the best.
ExactRow best_of_all(const NormalEquations& equations, std::uint32_t unknowns, const std::optional<double>& most) {
  std::uint32_t count = 1;
  for (std::uint32_t k = 0; k < unknowns; ++k) count *= 3;
  ExactRow best;
  Rational least = 0;
  for (std::uint32_t code = 0; code < count; ++code) {
    ExactRow x(unknowns, 0);
    std::vector<std::uint32_t> free;
    std::uint32_t rest = code;
    bool is_possible = true;
    for (std::uint32_t k = 0; k < unknowns; ++k, rest /= 3) {
      if (rest % 3 == 1) free.push_back(k);
      if (rest % 3 == 2) x[k] = Rational(most.value_or(0));
      is_possible = is_possible && (rest % 3 != 2 || most);
    }
    if (!is_possible) continue;
    x = equations.best(free, std::move(x));
    const auto is_within = [&](const Rational& v) { return v >= 0 && (!most || v <= Rational(*most)); };
    if (!std::ranges::all_of(x, is_within)) continue;
    const Rational cost = equations.cost(x);
    if (!best.empty() && cost >= least) continue;
    least = cost;
    best = std::move(x);
  }
  return best;
}

/// Lawson and Hanson's active sets, none below 0.
ExactRow nonnegative(const NormalEquations& equations, std::uint32_t unknowns) {
  ExactRow x(unknowns, 0);
  std::vector<std::uint32_t> free;
  while (true) {
    std::optional<std::uint32_t> steepest;
    for (std::uint32_t i = 0; i < unknowns; ++i) {
      if (std::ranges::find(free, i) != free.end() || equations.slope(i, x) >= 0) continue;
      if (!steepest || equations.slope(i, x) < equations.slope(*steepest, x)) steepest = i;
    }
    if (!steepest) return x;
    free.push_back(*steepest);
    while (true) {
      const ExactRow next = equations.best(free, ExactRow(unknowns, 0));
      Rational share = 1;
      for (const std::uint32_t i : free) {
        if (next[i] <= 0 && x[i] != next[i]) share = std::min(share, Rational(x[i] / (x[i] - next[i])));
      }
      for (std::uint32_t i = 0; i < unknowns; ++i) x[i] += share * (next[i] - x[i]);
      if (share == 1 && std::ranges::all_of(free, [&](std::uint32_t i) { return next[i] > 0; })) break;
      std::erase_if(free, [&](std::uint32_t i) { return x[i] <= 0; });
    }
  }
}

/// Columns that the others leave nearly nothing of, by Gram and Schmidt with the longest rest first.
void find_rank(std::span<const FitRow> rows, std::uint32_t unknowns, LinearFit& fit) {
  constexpr double nothing = 1e-12, little = 1e-6;
  std::vector<std::vector<double>> columns(unknowns, std::vector<double>(rows.size()));
  std::vector<double> length(unknowns, 0);
  for (std::uint32_t k = 0; k < unknowns; ++k) {
    for (std::size_t i = 0; i < rows.size(); ++i) columns[k][i] = rows[i].columns[k];
    length[k] = std::sqrt(std::inner_product(columns[k].begin(), columns[k].end(), columns[k].begin(), 0.0));
  }
  std::vector<bool> is_done(unknowns, false);
  for (std::uint32_t round = 0; round < unknowns; ++round) {
    std::uint32_t longest = unknowns;
    double most = -1;
    for (std::uint32_t k = 0; k < unknowns; ++k) {
      const double rest = std::sqrt(std::inner_product(columns[k].begin(), columns[k].end(), columns[k].begin(), 0.0));
      const double share = length[k] > 0 ? rest / length[k] : 0;
      if (!is_done[k] && share > most) {
        most = share;
        longest = k;
      }
    }
    is_done[longest] = true;
    if (most > nothing) ++fit.rank;
    if (most <= little) fit.undetermined.push_back(longest);
    if (most <= nothing) continue;
    const std::vector<double> base = columns[longest];
    const double square = std::inner_product(base.begin(), base.end(), base.begin(), 0.0);
    for (std::uint32_t k = 0; k < unknowns; ++k) {
      if (is_done[k]) continue;
      const double part = std::inner_product(base.begin(), base.end(), columns[k].begin(), 0.0) / square;
      for (std::size_t i = 0; i < rows.size(); ++i) columns[k][i] -= part * base[i];
    }
  }
  std::ranges::sort(fit.undetermined);
  fit.ill_conditioned = !fit.undetermined.empty();
}

Rational sum_of(const FitRow& row, const ExactRow& x) {
  Rational sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += Rational(row.columns[k]) * x[k];
  return sum;
}

/// 0 within the bounds.
Rational beyond(const FitRow& row, const Rational& sum) {
  if (std::isfinite(row.least) && sum < Rational(row.least)) return sum - Rational(row.least);
  if (std::isfinite(row.most) && sum > Rational(row.most)) return sum - Rational(row.most);
  return 0;
}

/// Rows a x >= least and a x <= most, and x <= 1, each with a slack; the row that each comes from.
struct BoundsProgram {
  StandardProgram program;

  BoundsProgram(std::span<const FitRow> rows, std::uint32_t unknowns) {
    program.columns.resize(unknowns);
    const auto add = [&](const auto& column, double right, int slack) {
      for (std::uint32_t k = 0; k < unknowns; ++k) program.columns[k].push_back(column(k));
      program.right.emplace_back(right);
      slacks.push_back(slack);
    };
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
      const auto column = [&](std::uint32_t k) { return Rational(rows[i].columns[k]); };
      if (std::isfinite(rows[i].least)) add(column, rows[i].least, -1);
      if (std::isfinite(rows[i].most)) add(column, rows[i].most, 1);
    }
    for (std::uint32_t u = 0; u < unknowns; ++u) {
      add([&](std::uint32_t k) { return Rational(k == u ? 1 : 0); }, 1, 1);
    }
    for (std::size_t i = 0; i < slacks.size(); ++i) {
      program.columns.emplace_back(slacks.size(), 0);
      program.columns.back()[i] = slacks[i];
    }
    program.cost.assign(program.columns.size(), 0);
  }

  /// One more equation: an unknown has a value.
  void fix(std::uint32_t unknown, const Rational& value) {
    for (std::size_t k = 0; k < program.columns.size(); ++k) program.columns[k].emplace_back(k == unknown ? 1 : 0);
    program.right.push_back(value);
  }

 private:
  std::vector<int> slacks;
};

/// Rows whose bounds exclude each other: y >= 0 with Σ y (a x) >= 0 for all x >= 0 and Σ y right = -1, for rows
/// a x <= right. A corner of such y has one entry more than there are unknowns at most.
std::vector<std::uint32_t> excluding_rows(std::span<const FitRow> rows, std::uint32_t unknowns) {
  StandardProgram program;
  std::vector<std::uint32_t> from;
  const auto add = [&](std::uint32_t row, int sign, double bound) {
    ExactRow& column = program.columns.emplace_back();
    for (std::uint32_t k = 0; k < unknowns; ++k) column.push_back(sign * Rational(rows[row].columns[k]));
    column.push_back(sign * Rational(bound));
    from.push_back(row);
  };
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    if (std::isfinite(rows[i].least)) add(i, -1, rows[i].least);
    if (std::isfinite(rows[i].most)) add(i, 1, rows[i].most);
  }
  // Unknowns of at most 1, and what is more than 0.
  for (const int sign : {1, -1}) {
    for (std::uint32_t u = 0; u < unknowns; ++u) {
      ExactRow& column = program.columns.emplace_back(unknowns + 1, 0);
      column[u] = sign;
      if (sign > 0) column.back() = 1;
    }
  }
  program.right.assign(unknowns + 1, 0);
  program.right.back() = -1;
  program.cost.assign(program.columns.size(), 0);
  const ProgramSolution solution = solved_program(program);
  std::vector<std::uint32_t> found;
  for (std::size_t k = 0; k < from.size() && !solution.y.empty(); ++k) {
    if (solution.y[k] != 0 && (found.empty() || found.back() != from[k])) found.push_back(from[k]);
  }
  return found;
}

}  // namespace

LinearFit least_squares(std::span<const FitRow> rows, std::uint32_t unknowns, std::optional<double> most) {
  constexpr std::uint32_t few = 3;
  const NormalEquations equations(rows, unknowns);
  const ExactRow x =
      unknowns <= few || most ? best_of_all(equations, unknowns, most) : nonnegative(equations, unknowns);
  LinearFit fit;
  for (const Rational& v : x) fit.values.push_back(nearest_double(v));
  for (const FitRow& row : rows) fit.residuals.push_back(nearest_double(sum_of(row, x) - Rational(row.wanted)));
  find_rank(rows, unknowns, fit);
  return fit;
}

LinearFit within_bounds(std::span<const FitRow> rows, std::uint32_t unknowns) {
  BoundsProgram bounds(rows, unknowns);
  LinearFit fit;
  find_rank(rows, unknowns, fit);
  if (unknowns > 0) bounds.program.cost[0] = 1;
  ProgramSolution solution = solved_program(bounds.program);
  if (solution.kind == ProgramSolution::Kind::infeasible) {
    fit.is_feasible = false;
    fit.conflict = excluding_rows(rows, unknowns);
    return fit;
  }
  if (unknowns > 1) {
    bounds.fix(0, solution.y[0]);
    bounds.program.cost[0] = 0;
    bounds.program.cost[1] = -1;
    solution = solved_program(bounds.program);
  }
  const ExactRow x(solution.y.begin(), solution.y.begin() + unknowns);
  for (const Rational& v : x) fit.values.push_back(nearest_double(v));
  for (const FitRow& row : rows) fit.residuals.push_back(nearest_double(beyond(row, sum_of(row, x))));
  return fit;
}

}  // namespace gnomon
