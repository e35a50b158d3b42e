#include <benchmark/benchmark.h>

#include "apps/proof/report/reflection_peers.h"
#include "apps/proof/report/table_one.h"
#include "geometry/visibility/fast_linear_visibility.h"
#include "geometry/visibility/fast_visibility.h"
#include "shading/reflection/area_reflection.h"
#include "shading/reflection/linear_reflection.h"
#include "shading/reflection/small_reflection.h"

namespace gnomon {
namespace {

/// A point of a floor, an eye above and before it, lights 10 long and 5 above: [PA90]. The argument is the exponent.
shading::ReflectionQuery visibility_with(ReflectionModel model, const benchmark::State& state) {
  return {{0.3, 0.2, 0}, {0, 0, 1}, shading::of_size_one({0.1, -1, 0.8}), {model, static_cast<int>(state.range(0))}};
}

void reflection_point(benchmark::State& state) {
  const shading::ReflectionQuery query = visibility_with(ReflectionModel::phong, state);
  for (auto unused : state) benchmark::DoNotOptimize(shading::point_reflection({{0, 1, 5}}, query));
}

void line(benchmark::State& state, ReflectionModel model) {
  const LinearLight tube{{-5, 1, 5}, {5, 1.25, 5}};
  const shading::ReflectionQuery query = visibility_with(model, state);
  const auto seen = FastLinearVisibility(tube, BlockerSet({})).visible_from(query.point);
  for (auto unused : state) benchmark::DoNotOptimize(shading::linear_reflection(tube, *seen, query));
}

void reflection_line(benchmark::State& state) {
  line(state, ReflectionModel::phong);
}

void reflection_line_blinn(benchmark::State& state) {
  line(state, ReflectionModel::blinn);
}

void lamp(benchmark::State& state, ReflectionModel model) {
  const AreaLight light{ConvexPolygon::from_points({{-5, 0, 5}, {-5, 2, 5}, {5, 2, 5}, {5, 0, 5}})};
  const shading::ReflectionQuery query = visibility_with(model, state);
  FastVisibility visibility(light, BlockerSet({}));
  const auto seen = visibility.visible_from(query.point);
  for (auto unused : state) benchmark::DoNotOptimize(shading::area_reflection(*seen, query));
}

void reflection_lamp(benchmark::State& state) {
  lamp(state, ReflectionModel::phong);
}

void reflection_lamp_blinn(benchmark::State& state) {
  lamp(state, ReflectionModel::blinn);
}

/// What points on a light take for an error, beside gnomon: a counter for each task, in microseconds.
void reflection_points_with_rays(benchmark::State& state) {
  for (auto unused : state) {
    for (const report::Timing& timing : report::reflection_peers(report::Effort::quick)) {
      state.counters[timing.task] = 1e6 * timing.seconds.median;
    }
  }
}

void reflection_sphere_picture(benchmark::State& state) {
  for (auto unused : state) {
    benchmark::DoNotOptimize(report::sphere_picture(static_cast<std::uint32_t>(state.range(0))));
  }
}

BENCHMARK(reflection_points_with_rays)->Iterations(1);
BENCHMARK(reflection_sphere_picture)->Arg(512)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(reflection_point)->Arg(10)->Arg(50)->Arg(200)->Arg(10000);
BENCHMARK(reflection_line)->Arg(10)->Arg(50)->Arg(200)->Arg(10000);
BENCHMARK(reflection_line_blinn)->Arg(50);
BENCHMARK(reflection_lamp)->Arg(1)->Arg(50)->Arg(200);
BENCHMARK(reflection_lamp_blinn)->Arg(50);

}  // namespace
}  // namespace gnomon
