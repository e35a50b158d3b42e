#include "shading/inverse/linear_program.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/dice.h"

namespace gnomon::inverse {
namespace {

using test_support::Dice;

StandardProgram drawn_program(Dice& dice) {
  const auto rows = static_cast<std::size_t>(dice.draw(1, 4)), columns = static_cast<std::size_t>(dice.draw(1, 9));
  StandardProgram program;
  for (std::size_t i = 0; i < rows; ++i) program.right.push_back(dice.draw(-3, 3));
  for (std::size_t k = 0; k < columns; ++k) {
    program.columns.emplace_back();
    for (std::size_t i = 0; i < rows; ++i) program.columns.back().push_back(dice.draw(-3, 3));
    program.cost.push_back(dice.draw(-2, 5));
  }
  return program;
}

Rational product(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  Rational sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

/// Right for certain: what solves, and multipliers of the same cost; or multipliers that contradict.
void expect_certified(const StandardProgram& program, const ProgramSolution& solution) {
  if (solution.kind == ProgramSolution::Kind::unbounded) return;
  const bool is_optimal = solution.kind == ProgramSolution::Kind::optimal;
  for (std::size_t k = 0; k < program.columns.size(); ++k) {
    EXPECT_LE(product(program.columns[k], solution.multipliers), is_optimal ? program.cost[k] : Rational(0));
  }
  if (!is_optimal) {
    EXPECT_GT(product(program.right, solution.multipliers), 0);
    return;
  }
  for (std::size_t i = 0; i < program.right.size(); ++i) {
    Rational sum = 0;
    for (std::size_t k = 0; k < program.columns.size(); ++k) sum += program.columns[k][i] * solution.y[k];
    EXPECT_EQ(sum, program.right[i]);
  }
  EXPECT_TRUE(std::ranges::all_of(solution.y, [](const Rational& y) { return y >= 0; }));
  EXPECT_EQ(product(program.cost, solution.y), product(program.right, solution.multipliers));
}

TEST(LinearProgramProperty, EveryAnswerComesWithItsProof) {
  std::array<int, 3> kinds{};
  for (std::uint32_t seed = 1; seed <= (GNOMON_LONG ? 20000 : 2000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const StandardProgram program = drawn_program(dice);
    const ProgramSolution solution = solved_program(program);
    ++kinds[static_cast<std::size_t>(solution.kind)];
    expect_certified(program, solution);
  }
  for (const int count : kinds) EXPECT_GT(count, 100);
}

TEST(LinearProgramProperty, UnboundedProgramsHaveARayOfFallingCost) {
  // y0 - y1 = 1, cost -y0: both grow without end.
  const StandardProgram program{{{1}, {-1}}, {1}, {-1, 0}};
  EXPECT_EQ(solved_program(program).kind, ProgramSolution::Kind::unbounded);
}

}  // namespace
}  // namespace gnomon::inverse
