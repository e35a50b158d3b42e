#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "gnomon/receiver_mesh.h"
#include "tests/benchmarks/mesh_models.h"

// A floor below one mesh under a lamp as wide as it, divided by all edge-vertex events and labelled. Counters:
// triangles, output faces, and the share of the floor that stays unresolved.
namespace gnomon::benchmarks {
namespace {

void divide(benchmark::State& state, const Triangles& triangles, unsigned threads = 1) {
  const std::vector<ConvexPolygon> floor{floor_below()};
  std::size_t faces = 0;
  double unresolved = 0;
  for (auto unused : state) {
    const ReceiverDivision division(wide_lamp(), triangles, floor, threads);
    const ReceiverMesh mesh = division.mesh(0, threads);
    faces = mesh.faces().size();
    state.PauseTiming();
    const auto areas = mesh.areas();
    unresolved = areas[static_cast<std::size_t>(ReceiverRegion::unresolved_eee)].nearest / mesh.area().nearest;
    state.ResumeTiming();
  }
  state.counters["triangles"] = static_cast<double>(triangles.size());
  state.counters["faces"] = static_cast<double>(faces);
  state.counters["unresolved"] = unresolved;
}

std::size_t size(const benchmark::State& state) {
  return static_cast<std::size_t>(state.range(0));
}

/// 144 triangles.
void floor_below_spiky_ball(benchmark::State& state) {
  divide(state, ball(7, 12, 0.4));
}

/// 960 facets.
void floor_below_sphere(benchmark::State& state) {
  divide(state, ball(16, 32, 1));
}

/// Closed, of n^2 triangles.
void floor_below_bumpy_ball(benchmark::State& state) {
  divide(state, ball(size(state) / 2 + 1, size(state), 0.8));
}

void floor_below_bumpy_ball_by_two_threads(benchmark::State& state) {
  divide(state, ball(size(state) / 2 + 1, size(state), 0.8), 2);
}

/// Open, of 2 n^2 triangles.
void floor_below_rough_sheet(benchmark::State& state) {
  divide(state, rough_sheet(size(state)));
}

/// 16 n thin triangles.
void floor_below_tufts(benchmark::State& state) {
  divide(state, tufts(size(state)));
}

BENCHMARK(floor_below_spiky_ball)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(floor_below_sphere)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(floor_below_bumpy_ball)->Arg(10)->Arg(20)->Arg(30)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(floor_below_bumpy_ball_by_two_threads)->Arg(30)->Iterations(1)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(floor_below_rough_sheet)->Arg(7)->Arg(22)->Arg(70)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(floor_below_tufts)->Arg(6)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gnomon::benchmarks
