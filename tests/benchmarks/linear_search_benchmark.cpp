#include <benchmark/benchmark.h>

#include <string>

#include "apps/proof/report/triangle_scenes.h"
#include "geometry/visibility/fast_linear_visibility.h"
#include "geometry/visibility/linear_search/light_triangle.h"
#include "tests/benchmarks/ratios.h"

// What a point sees of a linear light behind n triangles, search and exact intervals together, with each way of finding
// what may hide it. The counters tell, for a question, how many blockers were found, how many of them hide something,
// and how many nodes of a hierarchy or voxels were visited.
namespace gnomon::benchmarks {
namespace {

constexpr LinearLight tube{{-.5, 0, 4}, {.5, 0, 4}};

void linear_seen(benchmark::State& state, OccluderSearch search) {
  const report::TriangleScene scene = report::triangle_scene(static_cast<std::size_t>(state.range(0)));
  FastLinearVisibility visibility(tube, BlockerSet(scene.blockers), {search});
  std::size_t asked = 0;
  for (auto unused : state) {
    const auto seen = visibility.seen_from(scene.points[asked++ % scene.points.size()]);
    if (!seen) {
      state.SkipWithError("a point is left to the exact level");
      break;
    }
    benchmark::DoNotOptimize(seen->fraction);
  }
  const sight::SearchCounts& counts = visibility.search_counts();
  const auto of_question = [&](std::size_t count) { return static_cast<double>(count) / static_cast<double>(asked); };
  state.counters["candidates"] = of_question(counts.candidates);
  state.counters["visited"] = of_question(counts.visited);
}

/// From blockers as they are to the first answer.
void linear_set_up(benchmark::State& state, OccluderSearch search) {
  const report::TriangleScene scene = report::triangle_scene(static_cast<std::size_t>(state.range(0)));
  for (auto unused : state) {
    FastLinearVisibility visibility(tube, BlockerSet(scene.blockers), {search});
    benchmark::DoNotOptimize(visibility.seen_from(scene.points.front()));
  }
}

void linear_plane(benchmark::State& state) {
  linear_seen(state, OccluderSearch::plane);
}
void linear_hierarchy(benchmark::State& state) {
  linear_seen(state, OccluderSearch::hierarchy);
}
void linear_grid(benchmark::State& state) {
  linear_seen(state, OccluderSearch::grid);
}
void linear_light_buffer(benchmark::State& state) {
  linear_seen(state, OccluderSearch::light_buffer);
}
void linear_light_hierarchy(benchmark::State& state) {
  linear_seen(state, OccluderSearch::light_hierarchy);
}
void linear_set_up_hierarchy(benchmark::State& state) {
  linear_set_up(state, OccluderSearch::hierarchy);
}
void linear_set_up_light_hierarchy(benchmark::State& state) {
  linear_set_up(state, OccluderSearch::light_hierarchy);
}

BENCHMARK(linear_plane)->Arg(64)->Arg(1024);
BENCHMARK(linear_hierarchy)->Arg(1)->Arg(64)->Arg(1024)->Arg(16384);
BENCHMARK(linear_grid)->Arg(64)->Arg(1024)->Arg(16384);
BENCHMARK(linear_light_buffer)->Arg(64)->Arg(1024)->Arg(16384);
BENCHMARK(linear_light_hierarchy)->Arg(1)->Arg(64)->Arg(1024)->Arg(16384);
BENCHMARK(linear_set_up_hierarchy)->Arg(16384)->Unit(benchmark::kMillisecond);
BENCHMARK(linear_set_up_light_hierarchy)->Arg(16384)->Unit(benchmark::kMillisecond);

bool ratio(int n, double at_most) {
  const std::string argument = '/' + std::to_string(n);
  return add_ratio(
      {"linear_light_hierarchy" + argument, "linear_hierarchy" + argument, 1, at_most,
       "visible intervals, hierarchy about the light / hierarchy of boxes, " + std::to_string(n) + " triangles"});
}

const bool linear_asked = ratio(1, 0) && ratio(64, 0.8) && ratio(1024, 0.5) && ratio(16384, 0.8) &&
                          add_ratio({"linear_set_up_light_hierarchy/16384", "linear_set_up_hierarchy/16384", 1, 0,
                                     "set up for it / for the hierarchy of boxes, 16384 triangles"});

}  // namespace
}  // namespace gnomon::benchmarks
