#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "apps/proof/report/embree_visibility.h"
#include "apps/proof/report/measurement.h"
#include "apps/proof/report/triangle_scenes.h"
#include "geometry/visibility/fast_visibility.h"
#include "shading/lambert.h"
#include "tests/benchmarks/memory.h"
#include "tests/benchmarks/ratios.h"

// What a point sees of a square light behind n triangles: region, visible fraction and irradiance, the numbers with
// their bounds; and the irradiance alone by shadow rays, as many as relative errors of 1e-3 take in the root mean
// square.
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
    const std::optional<VisibleAreaLight> seen = looked.visibility.visible_from(p);
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
    const std::optional<VisibleAreaLight> seen = all[looked].visibility.visible_from(all[looked].scene.points[next]);
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
      : looked(std::move(drawn)),
        expected(irradiances(looked)),
        visibility(looked.scene.light, looked.scene.blockers) {}

  Looked looked;
  std::vector<double> expected;
  report::EmbreeVisibility visibility;
};

/// Of k * k stratified samples, at all points of the scenes together.
report::Errors sampling_errors(std::vector<Sampled>& all, std::size_t k) {
  report::Errors errors;
  for (Sampled& one : all) {
    one.visibility.place(report::Placing::stratified, k);
    for (std::size_t i = 0; i < one.expected.size(); ++i) {
      const double found = one.visibility.visible_from(one.looked.scene.points[i], up).irradiance;
      errors.add(std::fabs(found - one.expected[i]), one.expected[i]);
    }
  }
  errors.finish();
  return errors;
}

/// What was found for each k.
using ErrorsOfCells = std::map<std::size_t, report::Errors>;

/// The least k for which an error is at most 1e-3, by bisection down to a twentieth.
std::size_t cells_for(std::vector<Sampled>& all, ErrorsOfCells& found, double (*error)(const report::Errors&)) {
  const auto enough = [&](std::size_t k) {
    if (!found.contains(k)) found[k] = sampling_errors(all, k);
    return error(found[k]) <= 1e-3;
  };
  std::size_t least = 2;
  std::size_t most = 4;
  while (!enough(most) && most < 1024) {
    least = most;
    most = most * 3 / 2;
  }
  while (most - least > std::max<std::size_t>(least / 20, 1)) {
    const std::size_t middle = (least + most) / 2;
    (enough(middle) ? most : least) = middle;
  }
  return most;
}

/// With as many rays as errors of 1e-3 take, in the root mean square.
void visibility_by_rays(benchmark::State& state, report::Rays rays, double (*error)(const report::Errors&)) {
  std::vector<Sampled> all;
  for (report::TriangleScene& scene : report::triangle_scenes(blockers(state))) all.emplace_back(std::move(scene));
  ErrorsOfCells found;
  const std::size_t k = cells_for(all, found, error);
  for (Sampled& one : all) one.visibility.place(report::Placing::stratified, k, rays);
  std::size_t next = 0;
  for (auto unused : state) {
    Sampled& one = all[next % all.size()];
    benchmark::DoNotOptimize(one.visibility.visible_from(one.looked.scene.points[next % one.expected.size()], up));
    ++next;
  }
  state.counters["rays"] = static_cast<double>(k * k);
}

/// One by one, errors of each point's own irradiance.
void visibility_embree(benchmark::State& state) {
  visibility_by_rays(state, report::Rays::single, [](const report::Errors& e) { return e.relative_rms; });
}

/// In packets of eight, errors of the largest irradiance.
void visibility_embree_packets(benchmark::State& state) {
  visibility_by_rays(state, report::Rays::packets, [](const report::Errors& e) { return e.rms / e.largest; });
}

/// The light is known to be wholly visible: the sum over its four edges, with its bound.
void visibility_lambert_quad(benchmark::State& state) {
  const report::TriangleScene scene = report::triangle_scene(1);
  FastVisibility visibility(scene.light, BlockerSet({}));
  const std::optional<VisibleAreaLight> seen = visibility.visible_from(scene.points.front());
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
    benchmark::DoNotOptimize(visibility.visible_from(scene.points.front()));
    held = std::max(held, megabytes_in_use() - before);
    peak = std::max(peak, peak_megabytes());
  }
  state.counters["held_MB"] = held;
  state.counters["peak_MB"] = peak;
}

BENCHMARK(visibility_set_up)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(visibility_fast)->RangeMultiplier(4)->Range(1, 1024);
BENCHMARK(visibility_embree)->Arg(1)->Arg(64)->Arg(1024);
BENCHMARK(visibility_embree_packets)->Arg(1)->Arg(64)->Arg(1024);
BENCHMARK(visibility_lambert_quad);

bool ratio(int n, const std::string& rays, const std::string& error, double at_most) {
  const std::string argument = '/' + std::to_string(n);
  return add_ratio({"visibility_fast" + argument, rays + argument, 1, at_most,
                    "exact visibility / shadow rays at 1e-3 of " + error + ", " + std::to_string(n) + " triangles"});
}

bool ratios(int n, double at_most_of_single) {
  return ratio(n, "visibility_embree_packets", "the largest, in packets", 1.0 / 50) &&
         ratio(n, "visibility_embree", "each", at_most_of_single);
}

const bool visibility_asked = ratios(1, 1.0 / 200) && ratios(64, 1.0 / 30) && ratios(1024, 1.0 / 25);

}  // namespace
}  // namespace gnomon::benchmarks
