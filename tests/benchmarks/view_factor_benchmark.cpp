#include <benchmark/benchmark.h>

#include <cmath>

#include "gnomon/view_factors.h"
#include "tests/shading/illumination/factor_oracles.h"

namespace gnomon {
namespace {

/// Shapiro's case: what it takes to be within 1e-12 of the published value, and how far it is off.
void view_factor_shapiro(benchmark::State& state) {
  const std::vector<ViewSurface> squares = {{factors::rectangle_at(0, 0, 1, 1, 0, factors::Facing::up)},
                                            {factors::rectangle_at(0, 0, 1, 1, 1, factors::Facing::down)}};
  const Obstacles board{{factors::rectangle_at(.25, .25, .75, .75, .25, factors::Facing::up)}, {}};
  ViewFactors found;
  for (auto unused : state) found = view_factors(squares, board, {});
  state.counters["evaluations"] = static_cast<double>(found.evaluations);
  state.counters["error"] = std::fabs(found.factors.front().value - 0.115620602132415);
}

/// A unit cube of n x n squares a wall, with a box in it: the time of a pair, and how far row sums are from 1.
void view_factor_room(benchmark::State& state) {
  std::vector<ViewSurface> room = factors::cube_walls(static_cast<int>(state.range(0)));
  Obstacles box;
  factors::add_box(room, box.blockers, {.35, .35, .2}, {.65, .65, .6});
  ViewFactors found;
  for (auto unused : state) found = view_factors(room, box, {});
  std::vector<double> sums(room.size());
  for (const ViewFactor& f : found.factors) sums[f.from] += f.value;
  double residual = 0;
  for (const double sum : sums) residual = std::fmax(residual, std::fabs(sum - 1));
  const auto n = static_cast<double>(room.size());
  state.counters["row_sums_off"] = residual;
  state.counters["per_pair"] =
      benchmark::Counter(n * (n - 1) / 2, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK(view_factor_shapiro)->Unit(benchmark::kMillisecond);
BENCHMARK(view_factor_room)->Arg(2)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace gnomon
