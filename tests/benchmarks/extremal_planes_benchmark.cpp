#include "gnomon/pair.h"

#include <benchmark/benchmark.h>

#include <string>

#include "apps/proof/report/plain_walk.h"
#include "apps/proof/report/polygon_pairs.h"
#include "apps/proof/report/volume_peers.h"
#include "tests/benchmarks/cgal_baselines.h"
#include "tests/benchmarks/ratios.h"

// All extremal planes of a light and a blocker of n vertices each: exact (precondition checked), by the same walk in
// plain doubles (unchecked), and what the same volume costs when it is constructed.
namespace gnomon::benchmarks {
namespace {

bool same(const ExtremalPlanes& a, const ExtremalPlanes& b) {
  return a.separating_blocker == b.separating_blocker && a.separating_light == b.separating_light &&
         a.supporting_blocker == b.supporting_blocker;
}

void exact(benchmark::State& state) {
  const report::PolygonPair pair = report::generic_pair(static_cast<std::uint32_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(extremal_planes(pair.light, pair.blocker));
}

void exact_of_aligned_squares(benchmark::State& state) {
  const report::PolygonPair pair = report::aligned_squares();
  for (auto _ : state) benchmark::DoNotOptimize(extremal_planes(pair.light, pair.blocker));
}

void plain_doubles(benchmark::State& state) {
  const report::PolygonPair pair = report::generic_pair(static_cast<std::uint32_t>(state.range(0)));
  const auto& light = std::get<AreaLight>(pair.light);
  if (!same(report::plain_extremal_planes(light, pair.blocker), extremal_planes(pair.light, pair.blocker))) {
    state.SkipWithError("the plain walk names other planes");
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(report::plain_extremal_planes(light, pair.blocker));
}

void convex_hull(benchmark::State& state) {
  const report::PolygonPair pair = report::generic_pair(static_cast<std::uint32_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(report::facets_of_vertex_shadow_hull(pair));
}

void halfspace_intersection(benchmark::State& state) {
  const report::PolygonPair pair = report::generic_pair(static_cast<std::uint32_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(facets_of_halfspace_intersection(pair));
}

void all_sizes(benchmark::internal::Benchmark* b) {
  for (const int corners : {3, 4, 16, 256, 1024}) b->Arg(corners);
}

BENCHMARK(exact)->Name("extremal_planes/exact")->Apply(all_sizes);
BENCHMARK(exact_of_aligned_squares)->Name("extremal_planes/exact/aligned_squares");
BENCHMARK(plain_doubles)->Name("extremal_planes/plain_doubles")->Apply(all_sizes);
// The hull of 1024 times 1024 far points takes seconds, again and again.
BENCHMARK(convex_hull)->Name("extremal_planes/convex_hull_3")->Arg(3)->Arg(4)->Arg(16)->Arg(64)->Arg(256);
BENCHMARK(halfspace_intersection)->Name("extremal_planes/halfspace_intersection_3")->Apply(all_sizes);

[[maybe_unused]] const bool extremal_planes_asked = [] {
  const std::string exact_walk = "extremal_planes/exact/";
  const std::string plain_walk = "extremal_planes/plain_doubles/";
  for (const char* n : {"3", "4", "16", "256", "1024"}) {
    add_ratio({exact_walk + n, plain_walk + n, 1, 1.8, std::string("exact in units of plain doubles, ") + n});
  }
  add_ratio({exact_walk + "4", plain_walk + "4", 136, 300, "ns for exact 4/4, were plain doubles to take 136 ns"});
  add_ratio({exact_walk + "4", "extremal_planes/convex_hull_3/4", 59, 0.3,
             "us for exact 4/4, were convex_hull_3 to take 59 us"});
  add_ratio({exact_walk + "256", exact_walk + "16", 16.0 / 256, 1.3, "time per vertex, 256 against 16"});
  add_ratio({"extremal_planes/halfspace_intersection_3/4", exact_walk + "4", 1, 0,
             "halfspace_intersection_3 in units of exact, 4"});
  return true;
}();

}  // namespace
}  // namespace gnomon::benchmarks
