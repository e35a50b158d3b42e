#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "apps/report/embree_sight.h"
#include "apps/report/triangle_scenes.h"
#include "geometry/visibility/fast_visibility.h"
#include "shading/lambert.h"
#include "tests/benchmarks/memory.h"
#include "tests/benchmarks/ratios.h"

// What a point sees of a square light behind n triangles: region, visible fraction and irradiance, the numbers with
// their bounds; and the irradiance alone by shadow rays, as many as a root mean square error of 1e-3 takes.
namespace gnomon::benchmarks {
namespace {

constexpr Point3 up{0, 0, 1};

std::size_t blockers(const benchmark::State& state) {
  return static_cast<std::size_t>(state.range(0));
}

/// A scene and who looks at its points.
struct Looked {
  explicit Looked(report::TriangleScene drawn)
      : scene(std::move(drawn)), visibility(scene.light, BlockerSet(scene.blockers)) {}

  report::TriangleScene scene;
  FastVisibility visibility;
};

/// Of every point; 0 for one that is left to the exact level.
std::vector<double> irradiances(Looked& looked) {
  std::vector<double> values;
  for (const Point3& p : looked.scene.points) {
    const std::optional<LightSeen> seen = looked.visibility.seen_from(p);
    values.push_back(seen ? lambert_irradiance(*seen, up, 1).value : 0);
  }
  return values;
}

void visibility_fast(benchmark::State& state) {
  std::vector<Looked> all;
  for (report::TriangleScene& scene : report::triangle_scenes(blockers(state))) all.emplace_back(std::move(scene));
  std::size_t looked = 0;
  std::size_t next = 0;
  for (auto unused : state) {
    const std::optional<LightSeen> seen = all[looked].visibility.seen_from(all[looked].scene.points[next]);
    if (!seen) {
      state.SkipWithError("a point is left to the exact level");
      break;
    }
    benchmark::DoNotOptimize(lambert_irradiance(*seen, up, 1));
    if (++next < all[looked].scene.points.size()) continue;
    next = 0;
    looked = looked + 1 == all.size() ? 0 : looked + 1;
  }
}

/// A scene, its rays, and what they are to find.
struct Sampled {
  explicit Sampled(report::TriangleScene drawn)
      : looked(std::move(drawn)), expected(irradiances(looked)), sight(looked.scene.light, looked.scene.blockers) {}

  /// The error at each point, squared and added up.
  double squared_error() {
    double squares = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const double error = sight.seen_from(looked.scene.points[i], up).irradiance - expected[i];
      squares += error * error;
    }
    return squares;
  }

  Looked looked;
  std::vector<double> expected;
  report::EmbreeSight sight;
};

/// The least k of 4, 6, 8, 12, 16, ... whose root mean square error over all points is at most `relative` of the mean.
std::size_t cells_for_error(std::vector<Sampled>& all, double relative) {
  for (std::size_t k = 4;; k = k % 3 == 0 ? k / 3 * 4 : k / 2 * 3) {
    double squares = 0;
    double sum = 0;
    double count = 0;
    for (Sampled& one : all) {
      one.sight.place(report::Placing::stratified, k);
      squares += one.squared_error();
      sum = std::accumulate(one.expected.begin(), one.expected.end(), sum);
      count += static_cast<double>(one.expected.size());
    }
    if (std::sqrt(squares / count) <= relative * sum / count || k > 1000) return k;
  }
}

void visibility_embree(benchmark::State& state) {
  std::vector<Sampled> all;
  for (report::TriangleScene& scene : report::triangle_scenes(blockers(state))) all.emplace_back(std::move(scene));
  const std::size_t k = cells_for_error(all, 1e-3);
  std::size_t next = 0;
  for (auto unused : state) {
    Sampled& one = all[next % all.size()];
    benchmark::DoNotOptimize(one.sight.seen_from(one.looked.scene.points[next % one.expected.size()], up));
    ++next;
  }
  state.counters["rays"] = static_cast<double>(k * k);
}

/// The light is known to be wholly visible: the sum over its four edges, with its bound.
void visibility_lambert_quad(benchmark::State& state) {
  const report::TriangleScene scene = report::triangle_scene(1);
  FastVisibility visibility(scene.light, BlockerSet({}));
  const std::optional<LightSeen> seen = visibility.seen_from(scene.points.front());
  for (auto unused : state) benchmark::DoNotOptimize(lambert_irradiance(*seen, up, 1));
}

/// From blockers as they are to the first answer. The counters tell the heap's memory that hierarchy and blockers take,
/// and the peak of the process, which holds nothing else if this benchmark runs alone.
void visibility_set_up(benchmark::State& state) {
  double held = 0;
  double peak = 0;
  for (auto unused : state) {
    reset_peak();
    const double before = megabytes_in_use();
    const report::TriangleScene scene = report::triangle_scene(blockers(state));
    FastVisibility visibility(scene.light, BlockerSet(scene.blockers));
    benchmark::DoNotOptimize(visibility.seen_from(scene.points.front()));
    held = std::max(held, megabytes_in_use() - before);
    peak = std::max(peak, peak_megabytes());
  }
  state.counters["held_MB"] = held;
  state.counters["peak_MB"] = peak;
}

BENCHMARK(visibility_set_up)->Arg(100000)->Unit(benchmark::kMillisecond);
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
