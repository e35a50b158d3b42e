#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <atomic>

#include "apps/proof/report/box_stacks.h"
#include "geometry/parallel.h"
#include "gnomon/receiver_mesh.h"

// k x k stacks of 8 boxes on a floor, every face a receiver (48 k^2 + 1 of them), divided by all edge-vertex events and
// labelled: under a small distant light, and under a square light three stack heights above the floor.
namespace gnomon::benchmarks {
namespace {

enum class Threads { one, all };

/// Counters: receivers, output faces, and the largest memory of the process so far in MB.
void divide(benchmark::State& state, const Light& light, const report::BoxStacks& stacks,
            Threads threads = Threads::one) {
  std::atomic<std::size_t> faces = 0, events = 0;
  for (auto unused : state) {
    faces = events = 0;
    const ReceiverDivision division(light, stacks.boxes, stacks.receivers);
    const auto one = [&](std::size_t r, std::size_t) {
      const ReceiverMesh mesh = division.mesh(static_cast<std::uint32_t>(r));
      faces += mesh.faces().size();
      events += mesh.names().size();
    };
    for_all(division.size(), threads == Threads::all ? thread_count(0) : 1, one);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["receivers"] = static_cast<double>(stacks.receivers.size());
  state.counters["faces"] = static_cast<double>(faces);
  state.counters["events"] = static_cast<double>(events);
  state.counters["MB"] = static_cast<double>(usage.ru_maxrss) / 1024;
}

std::size_t stacks_along(const benchmark::State& state) {
  return static_cast<std::size_t>(state.range(0));
}

void stacks_under_distant_hexagon(benchmark::State& state) {
  const std::size_t k = stacks_along(state);
  divide(state, report::distant_hexagon(k), report::box_stacks(k));
}

void stacks_under_square(benchmark::State& state) {
  const std::size_t k = stacks_along(state);
  divide(state, report::square_above(k), report::box_stacks(k));
}

/// Events are found by one thread, receivers divided by all; what counts is the time that passes.
void stacks_under_distant_hexagon_by_all_threads(benchmark::State& state) {
  const std::size_t k = stacks_along(state);
  divide(state, report::distant_hexagon(k), report::box_stacks(k), Threads::all);
}

BENCHMARK(stacks_under_distant_hexagon)->DenseRange(1, 8)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(stacks_under_distant_hexagon_by_all_threads)
    ->Arg(5)
    ->Arg(8)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(stacks_under_square)->DenseRange(1, 8)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gnomon::benchmarks
