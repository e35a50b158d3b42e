#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "apps/proof/report/triangle_scenes.h"
#include "gnomon/sunlight.h"
#include "gnomon/visibility.h"
#include "tests/benchmarks/ratios.h"

// When the sun shines on 10,000 points behind 1,000 triangles through a day: in closed form, with every event named;
// and by asking at every minute, exactly, and exactly with a fast level first. All times are those of one point.
namespace gnomon::benchmarks {
namespace {

constexpr SunDay summer{.latitude = 52.5, .declination = 23.44};
constexpr int minutes = 24 * 60;
constexpr int sparse = 48;  ///< of the slowest, one in so many is asked, and the ratio multiplied

Point3 towards_sun(int minute) {
  constexpr double degree = std::numbers::pi / 180;
  const double h = (minute / 60.0 - 12) * 15 * degree, phi = summer.latitude * degree;
  const double delta = summer.declination * degree;
  return {-std::cos(delta) * std::sin(h),
          std::cos(phi) * std::sin(delta) - std::sin(phi) * std::cos(delta) * std::cos(h),
          std::sin(phi) * std::sin(delta) + std::cos(phi) * std::cos(delta) * std::cos(h)};
}

std::vector<Light> suns(int step = 1) {
  std::vector<Light> lights;
  for (int minute = 0; minute < minutes; minute += step) {
    const Point3 s = towards_sun(minute);
    if (s.z > 0) lights.emplace_back(DirectionalLight{{-s.x, -s.y, -s.z}});
  }
  return lights;
}

void sunlight_closed_form(benchmark::State& state) {
  const report::TriangleScene scene = report::triangle_scene(static_cast<std::size_t>(state.range(0)));
  const DaySunlight sun({scene.blockers, {}}, summer);
  constexpr std::size_t points = 10000;
  double hours = 0, events = 0;
  for (auto unused : state) {
    hours = events = 0;
    for (std::size_t k = 0; k < points; ++k) {
      Point3 p = scene.points[k % scene.points.size()];
      p.x += 1e-3 * static_cast<double>(k / scene.points.size());
      const SunlitDay day = sun.at({p, {}});
      hours += day.hours;
      events += 2 * static_cast<double>(day.intervals.size());
    }
  }
  state.counters["hours"] = hours / points;
  state.counters["events"] = events / points;
}

void sunlight_minutes_exact(benchmark::State& state) {
  const report::TriangleScene scene = report::triangle_scene(static_cast<std::size_t>(state.range(0)));
  const std::vector<Light> lights = suns(sparse);
  const Obstacles obstacles{scene.blockers, {}};
  std::size_t lit = 0;
  for (auto unused : state) {
    for (const Light& light : lights) lit += exact_visibility(light, obstacles, scene.points[0]).region == Region::lit;
  }
  benchmark::DoNotOptimize(lit);
}

void sunlight_minutes_fast(benchmark::State& state) {
  const report::TriangleScene scene = report::triangle_scene(static_cast<std::size_t>(state.range(0)));
  const std::vector<Light> lights = suns();
  const PreparedObstacles obstacles({scene.blockers, {}});
  std::vector<LightVisibility> visibilities;
  for (const Light& light : lights) visibilities.emplace_back(light, obstacles);
  std::size_t lit = 0, next = 0;
  for (auto unused : state) {
    const Point3& p = scene.points[next++ % scene.points.size()];
    for (LightVisibility& visibility : visibilities) lit += visibility.at(p).region == Region::lit;
  }
  benchmark::DoNotOptimize(lit);
}

BENCHMARK(sunlight_closed_form)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(sunlight_minutes_exact)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(sunlight_minutes_fast)->Arg(1000)->Unit(benchmark::kMillisecond);

const bool has_ratios =
    add_ratio(
        {"sunlight_minutes_exact/1000", "sunlight_closed_form/1000", 10000 * sparse, 0,
         "sunlight of a day behind 1,000 triangles: every minute by exact queries / in closed form (100 asked)"}) &&
    add_ratio({"sunlight_minutes_fast/1000", "sunlight_closed_form/1000", 10000, 0,
               "the same: every minute by exact queries with a fast level and everything prepared / in closed form"});

}  // namespace
}  // namespace gnomon::benchmarks
