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

/// About n triangles of a hilly ground under a slanting sun; they touch each other.
void merged_ground(benchmark::State& state) {
  const auto k = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(state.range(0)) / 2)));
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    const double x = 1.0 * i / k, y = 1.0 * j / k;
    return Point3{x, y, 0.5 + 0.1 * std::sin(6 * x) * std::cos(5 * y) + 0.02 / k * ((i * 7 + j * 13) % 5)};
  };
  std::vector<ConvexBlocker> parts;
  for (std::uint32_t i = 0; i < k; ++i) {
    for (std::uint32_t j = 0; j < k; ++j) {
      parts.push_back(ConvexPolygon::from_points({at(i, j), at(i + 1, j), at(i + 1, j + 1)}));
      parts.push_back(ConvexPolygon::from_points({at(i, j), at(i + 1, j + 1), at(i, j + 1)}));
    }
  }
  const Light sun = DirectionalLight{{0.3, 0.2, -1}};
  for (auto _ : state) benchmark::DoNotOptimize(merged_occlusion(sun, parts, {{-1, -1, -1}, {2, 2, 1.5}}));
}

/// n solids far apart under the same sun.
void merged_boxes(benchmark::State& state) {
  const auto k = static_cast<int>(std::lround(std::sqrt(static_cast<double>(state.range(0)))));
  std::vector<ConvexBlocker> parts;
  for (int i = 0; i < k * k; ++i) {
    std::vector<Point3> corners;
    for (int c = 0; c < 8; ++c) {
      corners.push_back({3.0 * (i % k) + c % 2, 3.0 * (i / k) + c / 2 % 2 + 0.1 * (c % 2), c / 4 + 0.05 * (i % k)});
    }
    parts.push_back(ConvexSolid::hull_of(corners));
  }
  const Light sun = DirectionalLight{{0.3, 0.2, -1}};
  for (auto _ : state) benchmark::DoNotOptimize(merged_occlusion(sun, parts, {{-1, -1, -1}, {3.0 * k, 3.0 * k, 9}}));
}

BENCHMARK(merged_ground)->Name("merged/ground")->Arg(98)->Arg(2048)->Unit(benchmark::kMillisecond);
BENCHMARK(merged_boxes)->Name("merged/boxes")->Arg(100)->Arg(2025)->Unit(benchmark::kMillisecond);
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
  add_ratio({"merged/ground/2048", "merged/ground/98", 1, std::pow(2048.0 / 98, 1.3),
             "occlusions of 2,048 triangles of a ground as one, in units of 98 ((2048/98)^1.3 = 52)"});
  add_ratio({"merged/boxes/2025", "merged/boxes/100", 1, std::pow(20.25, 1.3),
             "those of 2,025 solids far apart, in units of 100 (20.25^1.3 = 50)"});
  add_ratio({"extremal_planes/convex_hull_3/4", polygons + "4", 1, 0, "convex_hull_3 of the occlusion alone, 4/4"});
  add_ratio({"extremal_planes/convex_hull_3/64", polygons + "64", 1, 0, "the same, 64/64"});
  return true;
}();

}  // namespace
}  // namespace gnomon::benchmarks
