#include <CGAL/Arr_linear_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "geometry/planar/partition.h"
#include "geometry/planar/sight.h"
#include "tests/benchmarks/ratios.h"

// A light of the plane among n random segments: what points see of it, the exact partition of the plane, and beside it
// the plain arrangement of all lines that Q5 allows.
namespace gnomon::benchmarks {
namespace {

using planar::BlockerSegment;
using planar::Flatland;
using planar::Partition;
using planar::Sight;

/// Segments of a length that leaves some light between any number of them.
Flatland random_flatland(std::int64_t n) {
  std::mt19937 random(7);
  const auto draw = [&](double reach) { return reach * (2 * (random() / 4294967295.0) - 1); };
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
  for (Point2& p : points) p = {20 * (random() / 4294967295.0) - 10, 20 * (random() / 4294967295.0) - 10};
  return points;
}

void visible_intervals(benchmark::State& state) {
  const Sight sight(random_flatland(state.range(0)));
  const std::vector<Point2> points = random_points();
  std::size_t next = 0, seen = 0;
  for (auto _ : state) {
    seen += sight.visible_light(points[next]).intervals.size();
    next = (next + 1) % points.size();
  }
  state.counters["intervals"] = double(seen) / double(state.iterations());
}

void partition_of_plane(benchmark::State& state) {
  const Sight sight(random_flatland(state.range(0)));
  std::size_t faces = 0, edges = 0;
  for (auto _ : state) {
    const Partition parts = planar::partition(sight);
    faces = parts.faces().size(), edges = parts.edges().size();
  }
  state.counters["faces"] = double(faces);
  state.counters["edges"] = double(edges);
  state.counters["us_per_edge"] = benchmark::Counter(
      double(edges) * 1e-6, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
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

BENCHMARK(visible_intervals)->Name("planar/visible_intervals")->Arg(10)->Arg(100)->Arg(1000);
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

[[maybe_unused]] const bool asked = [] {
  add_ratio(
      {"planar/all_lines/5", "planar/partition/5", 1, 0, "arrangement of all lines in units of the partition, 5"});
  add_ratio(
      {"planar/all_lines/10", "planar/partition/10", 1, 0, "arrangement of all lines in units of the partition, 10"});
  add_ratio({"planar/visible_intervals/1000", "planar/visible_intervals/100", 1, 0,
             "visible intervals at a point, 1,000 segments against 100"});
  return true;
}();

}  // namespace
}  // namespace gnomon::benchmarks
