#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "geometry/visibility/fast_visibility.h"
#include "shading/lambert.h"
#include "tests/benchmarks/embree_sampling.h"
#include "tests/benchmarks/ratios.h"
#include "tests/benchmarks/triangle_scenes.h"

// What a point sees of a square light behind n triangles: region, visible fraction and irradiance, the numbers with
// their bounds; and the irradiance alone by shadow rays, as many as a root mean square error of 1e-3 takes.
namespace gnomon::benchmarks {
namespace {

constexpr Point3 up{0, 0, 1};

std::size_t blockers(const benchmark::State& state) {
  return static_cast<std::size_t>(state.range(0));
}

/// Of every point; a point that is left to the exact level counts in `open`.
std::vector<double> irradiances(const TriangleScene& scene, std::size_t& open) {
  FastVisibility visibility(scene.light, BlockerSet(scene.blockers));
  std::vector<double> values;
  for (const Point3& p : scene.points) {
    const std::optional<LightSeen> seen = visibility.seen_from(p);
    if (!seen) ++open;
    values.push_back(seen ? lambert_irradiance(*seen, up, 1).value : 0);
  }
  return values;
}

void visibility_fast(benchmark::State& state) {
  const TriangleScene scene = triangle_scene(blockers(state));
  FastVisibility visibility(scene.light, BlockerSet(scene.blockers));
  std::size_t next = 0;
  for (auto unused : state) {
    const std::optional<LightSeen> seen = visibility.seen_from(scene.points[next]);
    if (!seen) {
      state.SkipWithError("a point is left to the exact level");
      break;
    }
    benchmark::DoNotOptimize(lambert_irradiance(*seen, up, 1));
    next = next + 1 == scene.points.size() ? 0 : next + 1;
  }
}

void visibility_embree(benchmark::State& state) {
  const TriangleScene scene = triangle_scene(blockers(state));
  EmbreeSampling sampling(scene);
  std::size_t open = 0;
  const std::vector<double> expected = irradiances(scene, open);
  const std::size_t k = cells_for_error(sampling, scene, expected, 1e-3);
  std::size_t next = 0;
  for (auto unused : state) {
    benchmark::DoNotOptimize(sampling.irradiance(scene.points[next], k));
    next = next + 1 == scene.points.size() ? 0 : next + 1;
  }
  state.counters["rays"] = static_cast<double>(k * k);
}

/// The light is known to be wholly visible: the sum over its four edges, with its bound.
void visibility_lambert_quad(benchmark::State& state) {
  const TriangleScene scene = triangle_scene(1);
  FastVisibility visibility(scene.light, BlockerSet({}));
  const std::optional<LightSeen> seen = visibility.seen_from(scene.points.front());
  for (auto unused : state) benchmark::DoNotOptimize(lambert_irradiance(*seen, up, 1));
}

BENCHMARK(visibility_fast)->RangeMultiplier(4)->Range(1, 1024);
BENCHMARK(visibility_embree)->Arg(1)->Arg(64)->Arg(1024);
BENCHMARK(visibility_lambert_quad);

bool ratio(int n, double at_most) {
  const std::string argument = '/' + std::to_string(n);
  return add_ratio({"visibility_fast" + argument, "visibility_embree" + argument, 1, at_most,
                    "exact visibility / shadow rays at 1e-3, " + std::to_string(n) + " triangles"});
}

const bool asked = ratio(1, 1.0 / 200) && ratio(64, 1.0 / 30) && ratio(1024, 1.0 / 25);

}  // namespace
}  // namespace gnomon::benchmarks
