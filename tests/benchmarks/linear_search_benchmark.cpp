#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "apps/proof/report/draws.h"
#include "apps/proof/report/embree_rays.h"
#include "apps/proof/report/triangle_scenes.h"
#include "geometry/visibility/common_part.h"
#include "geometry/visibility/fast_linear_visibility.h"
#include "geometry/visibility/linear_search/light_triangle.h"
#include "tests/benchmarks/ratios.h"

// What a point sees of a linear light behind n triangles, search and exact intervals together, with each way of finding
// what may hide it. The counters tell, for a question, how many blockers were found and how many nodes of a hierarchy
// or voxels were visited; and how many blockers are found for each that has a point between the two, of 64 points.
namespace gnomon::benchmarks {
namespace {

constexpr LinearLight tube{{-.5, 0, 4}, {.5, 0, 4}};

/// Blockers found for each in the triangle between point and light, exactly.
double found_for_each_needed(FastLinearVisibility& visibility, const report::TriangleScene& scene) {
  const BlockerSet blockers(scene.blockers);
  std::size_t found = 0, needed = 0;
  for (const Point3& p : std::span(scene.points).first(64)) {
    const auto occluders = visibility.occluders(p);
    if (!occluders) continue;
    const std::array triangle{p, tube.start, tube.end};
    for (const std::uint32_t b : *occluders)
      needed += viewpoint::have_common_point(blockers.content(), b, triangle) ? 1 : 0;
    found += occluders->size();
  }
  return static_cast<double>(found) / static_cast<double>(std::max<std::size_t>(needed, 1));
}

void linear_seen(benchmark::State& state, OccluderSearch search) {
  const report::TriangleScene scene = report::triangle_scene(static_cast<std::size_t>(state.range(0)));
  FastLinearVisibility visibility(tube, BlockerSet(scene.blockers), {search});
  std::size_t asked = 0;
  for (auto unused : state) {
    const auto seen = visibility.visible_from(scene.points[asked++ % scene.points.size()]);
    if (!seen) {
      state.SkipWithError("a point is left to the exact level");
      break;
    }
    benchmark::DoNotOptimize(seen->fraction);
  }
  const viewpoint::SearchCounts& counts = visibility.search_counts();
  const auto of_question = [&](std::size_t count) { return static_cast<double>(count) / static_cast<double>(asked); };
  state.counters["candidates"] = of_question(counts.candidates);
  state.counters["visited"] = of_question(counts.visited);
  if (search != OccluderSearch::plane) state.counters["per_needed"] = found_for_each_needed(visibility, scene);
}

/// Visible fractions by shadow rays of Embree to k jittered points of the light, one in each of k equal parts.
class SampledTube {
 public:
  explicit SampledTube(const report::TriangleScene& scene) : rays_(scene.blockers) {}

  double fraction(const Point3& p, std::uint32_t k) {
    std::uint32_t seen = 0;
    for (std::uint32_t i = 0; i < k; ++i) {
      const double share = (i + draws_.between(0, 1)) / k;
      const double x = tube.start.x + share * (tube.end.x - tube.start.x);
      seen += rays_.is_hidden(p, {x - p.x, tube.start.y - p.y, tube.start.z - p.z}) ? 0 : 1;
    }
    return 1.0 * seen / k;
  }

 private:
  report::EmbreeRays rays_;
  report::Draws draws_{24};
};

/// The root of the mean square of what the fractions of all points are off by.
double sampling_error(const report::TriangleScene& scene, SampledTube& sampled, std::uint32_t k) {
  FastLinearVisibility exact(tube, BlockerSet(scene.blockers));
  double sum = 0;
  for (const Point3& p : scene.points) {
    const double error = sampled.fraction(p, k) - exact.visible_from(p)->fraction;
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(scene.points.size()));
}

/// With as many points as an error of 1e-3 takes, by steps of a quarter.
void linear_by_rays(benchmark::State& state) {
  const report::TriangleScene scene = report::triangle_scene(static_cast<std::size_t>(state.range(0)));
  SampledTube sampled(scene);
  std::uint32_t k = 16;
  while (sampling_error(scene, sampled, k) > 1e-3) k += k / 4;
  std::size_t asked = 0;
  for (auto unused : state) {
    benchmark::DoNotOptimize(sampled.fraction(scene.points[asked++ % scene.points.size()], k));
  }
  state.counters["rays"] = k;
}

/// From blockers as they are to the first answer.
void linear_set_up(benchmark::State& state, OccluderSearch search) {
  const report::TriangleScene scene = report::triangle_scene(static_cast<std::size_t>(state.range(0)));
  for (auto unused : state) {
    FastLinearVisibility visibility(tube, BlockerSet(scene.blockers), {search});
    benchmark::DoNotOptimize(visibility.visible_from(scene.points.front()));
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
BENCHMARK(linear_by_rays)->Arg(64)->Arg(1024);
BENCHMARK(linear_set_up_hierarchy)->Arg(16384)->Unit(benchmark::kMillisecond);
BENCHMARK(linear_set_up_light_hierarchy)->Arg(16384)->Unit(benchmark::kMillisecond);

bool ratio(int n, double at_most) {
  const std::string argument = '/' + std::to_string(n);
  return add_ratio(
      {"linear_light_hierarchy" + argument, "linear_hierarchy" + argument, 1, at_most,
       "visible intervals, hierarchy about the light / hierarchy of boxes, " + std::to_string(n) + " triangles"});
}

bool ratio_to_rays(int n) {
  const std::string argument = '/' + std::to_string(n);
  return add_ratio({"linear_light_hierarchy" + argument, "linear_by_rays" + argument, 1, 1.0 / 30,
                    "visible intervals / shadow rays at 1e-3, " + std::to_string(n) + " triangles"});
}

const bool linear_asked = ratio_to_rays(64) && ratio_to_rays(1024) && ratio(1, 0) && ratio(64, 0.8) &&
                          ratio(1024, 0.5) && ratio(16384, 0.8) &&
                          add_ratio({"linear_set_up_light_hierarchy/16384", "linear_set_up_hierarchy/16384", 1, 0,
                                     "set up for it / for the hierarchy of boxes, 16384 triangles"});

}  // namespace
}  // namespace gnomon::benchmarks
