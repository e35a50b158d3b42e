#include "gnomon/shadow_mesh.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "apps/proof/report/polygon_pairs.h"
#include "apps/proof/report/spheres.h"
#include "tests/benchmarks/memory.h"
#include "tests/benchmarks/ratios.h"

// Occlusion and umbra as closed meshes with correctly rounded vertices, cut by a box: of polygons of n vertices each,
// of solids of n facets below a square lamp, and of all facets of a mesh, part by part.
namespace gnomon::benchmarks {
namespace {

constexpr ShadowParts surfaces{.penumbra = false, .cells = false, .planes = false, .volumes = false};

/// A box about the pair and some of its shadow, in which nothing is aligned.
constexpr Box3 box{{-9.1, -8.7, -9.3}, {8.9, 9.2, 9.4}};

void meshes(benchmark::State& state) {
  const report::PolygonPair pair = report::generic_pair(static_cast<std::uint32_t>(state.range(0)));
  const ConvexBlocker blocker = pair.blocker;
  for (auto _ : state) benchmark::DoNotOptimize(shadow_meshes(pair.light, blocker, box, surfaces));
}

void meshes_of_aligned_squares(benchmark::State& state) {
  const report::PolygonPair pair = report::aligned_squares();
  const ConvexBlocker blocker = pair.blocker;
  for (auto _ : state) benchmark::DoNotOptimize(shadow_meshes(pair.light, blocker, box, surfaces));
}

void solid(benchmark::State& state) {
  const Light light = report::lamp_above_sphere();
  const ConvexBlocker blocker = report::sphere(static_cast<std::uint32_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(shadow_meshes(light, blocker, box, surfaces));
}

/// All meshes are held at once; the counter `held_MB` tells the memory that they take.
void parts_of_a_mesh(benchmark::State& state) {
  const Light light = report::lamp_above_sphere();
  const std::vector<ConvexBlocker> parts = report::sphere_facets(static_cast<std::uint32_t>(state.range(0)));
  double held = 0;
  for (auto _ : state) {
    const double before = megabytes_in_use();
    std::vector<ShadowMeshes> meshes;
    for (const ConvexBlocker& part : parts) meshes.push_back(shadow_meshes(light, part, box, surfaces));
    benchmark::DoNotOptimize(meshes);
    held = std::max(held, megabytes_in_use() - before);
  }
  state.counters["held_MB"] = held;
}

BENCHMARK(meshes)->Name("volume_mesh/polygons")->Arg(3)->Arg(4)->Arg(16)->Arg(64)->Arg(256)->Arg(1024);
BENCHMARK(meshes_of_aligned_squares)->Name("volume_mesh/aligned_squares");
BENCHMARK(solid)->Name("volume_mesh/solid")->Arg(100)->Arg(1000);
BENCHMARK(parts_of_a_mesh)->Name("volume_mesh/triangles_of_a_mesh")->Arg(5000)->Unit(benchmark::kMillisecond);

[[maybe_unused]] const bool volume_mesh_asked = [] {
  const std::string polygons = "volume_mesh/polygons/";
  const std::string plain = "extremal_planes/plain_doubles/4";
  add_ratio({polygons + "4", plain, 0.136, 10, "us for both meshes 4/4, were plain doubles to take 136 ns"});
  add_ratio({polygons + "64", plain, 0.136, 150, "us for both meshes 64/64, likewise"});
  add_ratio(
      {polygons + "1024", polygons + "64", 1, std::pow(16, 1.15), "1024/1024 in units of 64/64 (16^1.15 = 24.3)"});
  add_ratio({"volume_mesh/solid/1000", plain, 0.000136, 5, "ms for both meshes of a solid of 1,000 facets, likewise"});
  add_ratio({"volume_mesh/triangles_of_a_mesh/5000", plain, 0.000000136, 1,
             "s for both meshes of each of 5,000 triangles, likewise"});
  add_ratio({"extremal_planes/convex_hull_3/4", polygons + "4", 1, 0, "convex_hull_3 of the occlusion alone, 4/4"});
  add_ratio({"extremal_planes/convex_hull_3/64", polygons + "64", 1, 0, "the same, 64/64"});
  return true;
}();

}  // namespace
}  // namespace gnomon::benchmarks
