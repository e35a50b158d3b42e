#include <CGAL/Arr_linear_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "gnomon/flatland.h"
#include "gnomon/flatland_partition.h"
#include "tests/benchmarks/ratios.h"

// A light of the plane among n random segments: what points see of it, the exact partition of the plane, and beside it
// the plain arrangement of all lines that Q5 allows.
namespace gnomon::benchmarks {
namespace {

using planar::BlockerSegment;
using planar::Flatland;
using planar::Partition;
using planar::PartitionLocation;

/// Segments of a length that leaves some light between any number of them.
Flatland random_flatland(std::int64_t n) {
  std::mt19937 random(7);
  const auto draw = [&](double reach) { return reach * (2 * (double(random()) / 4294967295.0) - 1); };
  const double length = 10 / std::sqrt(double(n));
  std::vector<BlockerSegment> blockers;
  for (std::int64_t i = 0; i < n; ++i) {
    const Point2 a{draw(10), draw(10)};
    blockers.push_back({a, Point2{a.x + draw(length), a.y + draw(length)}});
  }
  return Flatland::from_points(std::vector<Point2>{{-2, 0.5}, {2, -0.25}}, blockers);
}

std::vector<Point2> random_points() {
  std::mt19937 random(11);
  std::vector<Point2> points(256);
  for (Point2& p : points)
    p = {20 * (double(random()) / 4294967295.0) - 10, 20 * (double(random()) / 4294967295.0) - 10};
  return points;
}

void visible_intervals(benchmark::State& state) {
  const planar::LightVisibility visibility(random_flatland(state.range(0)));
  const std::vector<Point2> points = random_points();
  std::size_t next = 0, seen = 0;
  for (auto _ : state) {
    seen += visibility.visible_light(points[next]).intervals.size();
    next = (next + 1) % points.size();
  }
  state.counters["intervals"] = double(seen) / double(state.iterations());
}

void region_by_definition(benchmark::State& state) {
  const planar::LightVisibility visibility(random_flatland(state.range(0)));
  const std::vector<Point2> points = random_points();
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(visibility.region(points[next]));
    next = (next + 1) % points.size();
  }
}

void region_by_location(benchmark::State& state) {
  const planar::LightVisibility visibility(random_flatland(state.range(0)));
  const PartitionLocation location(planar::partition(visibility));
  const std::vector<Point2> points = random_points();
  for (const Point2& p : points) {
    if (location.region(p) != visibility.region(p)) return state.SkipWithError("the regions differ");
  }
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(location.region(points[next]));
    next = (next + 1) % points.size();
  }
}

void intervals_by_location(benchmark::State& state) {
  const planar::LightVisibility visibility(random_flatland(state.range(0)));
  const PartitionLocation location(planar::partition(visibility, {planar::Fineness::structure, {}}));
  const std::vector<Point2> points = random_points();
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(location.visible_light(points[next]));
    next = (next + 1) % points.size();
  }
}

void location_building(benchmark::State& state) {
  const Partition parts = planar::partition(planar::LightVisibility(random_flatland(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(PartitionLocation(parts));
}

/// Asks for the growth of the time per edge, as soon as the edges of both sizes are counted.
void ask_growth(std::int64_t n, std::size_t edges) {
  static std::map<std::int64_t, std::size_t> counted;
  const bool is_new = counted.insert({n, edges}).second;
  if (!is_new || (n != 20 && n != 100) || !counted.contains(20) || !counted.contains(100)) return;
  add_ratio({"planar/partition/100", "planar/partition/20", double(counted[20]) / double(counted[100]), 0,
             "partition, time per edge of the result, 100 segments against 20"});
}

void partition_of_plane(benchmark::State& state) {
  const planar::LightVisibility visibility(random_flatland(state.range(0)));
  std::size_t faces = 0, edges = 0;
  for (auto _ : state) {
    const Partition parts = planar::partition(visibility);
    faces = parts.faces().size(), edges = parts.edges().size();
  }
  state.counters["faces"] = double(faces);
  state.counters["edges"] = double(edges);
  ask_growth(state.range(0), edges);
  state.counters["per_edge"] =
      benchmark::Counter(double(edges), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// All lines through two ends.
void all_lines(benchmark::State& state) {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Traits = CGAL::Arr_linear_traits_2<Kernel>;
  const Flatland flatland = random_flatland(state.range(0));
  std::vector<Kernel::Point_2> ends;
  for (const Point2& p : flatland.light()) ends.emplace_back(p.x, p.y);
  for (const BlockerSegment& blocker : flatland.blockers()) {
    for (const Point2& p : blocker) ends.emplace_back(p.x, p.y);
  }
  std::vector<Traits::Curve_2> lines;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) lines.emplace_back(Kernel::Line_2(ends[i], ends[j]));
  }
  std::size_t faces = 0;
  for (auto _ : state) {
    CGAL::Arrangement_2<Traits> arrangement;
    CGAL::insert(arrangement, lines.begin(), lines.end());
    faces = arrangement.number_of_faces();
  }
  state.counters["faces"] = double(faces);
}

BENCHMARK(visible_intervals)->Name("planar/visible_intervals")->Arg(10)->Arg(20)->Arg(100)->Arg(1000);
BENCHMARK(region_by_definition)->Name("planar/region_by_sight")->Arg(20)->Arg(100);
BENCHMARK(region_by_location)->Name("planar/region_by_location")->Arg(20)->Arg(100);
BENCHMARK(intervals_by_location)->Name("planar/intervals_by_location")->Arg(20)->Arg(100);
BENCHMARK(location_building)->Name("planar/location_building")->Arg(20)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(partition_of_plane)
    ->Name("planar/partition")
    ->Arg(5)
    ->Arg(10)
    ->Arg(20)
    ->Arg(50)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);
// With 20 segments the lines make half a million faces.
BENCHMARK(all_lines)->Name("planar/all_lines")->Arg(5)->Arg(10)->Unit(benchmark::kMillisecond);

[[maybe_unused]] const bool planar_asked = [] {
  add_ratio(
      {"planar/all_lines/5", "planar/partition/5", 1, 0, "arrangement of all lines in units of the partition, 5"});
  add_ratio(
      {"planar/all_lines/10", "planar/partition/10", 1, 0, "arrangement of all lines in units of the partition, 10"});
  add_ratio({"planar/visible_intervals/1000", "planar/visible_intervals/100", 1, 0,
             "visible intervals at a point, 1,000 segments against 100"});
  add_ratio({"planar/region_by_sight/20", "planar/region_by_location/20", 1, 0,
             "region of a point by visibility in units of location in the partition, 20"});
  add_ratio({"planar/region_by_sight/100", "planar/region_by_location/100", 1, 0,
             "region of a point by visibility in units of location in the partition, 100"});
  return true;
}();

}  // namespace
}  // namespace gnomon::benchmarks
