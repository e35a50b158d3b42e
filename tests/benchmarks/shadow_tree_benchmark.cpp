#include <benchmark/benchmark.h>

#include <string>

#include "apps/proof/report/embree_rays.h"
#include "apps/proof/report/triangle_scenes.h"
#include "geometry/visibility/fast_point_visibility.h"
#include "geometry/visibility/shadow_tree.h"
#include "gnomon/receiver_mesh.h"
#include "tests/benchmarks/ratios.h"

// Whether points see a point light behind n triangles: by a shadow tree, by the hierarchy of boxes, both exact, and by
// a shadow ray of Embree. Then how long the tree takes to be built; and a floor cut by it into lit and shadowed pieces,
// beside its division by events.
namespace gnomon::benchmarks {
namespace {

constexpr PointLight lamp{{0.1, 0.05, 4}};

report::TriangleScene scene_of(const benchmark::State& state) {
  return report::triangle_scene(static_cast<std::size_t>(state.range(0)));
}

/// Asks for one point after the other.
template <class IsHidden>
void ask(benchmark::State& state, const report::TriangleScene& scene, const IsHidden& is_hidden) {
  std::size_t next = 0;
  for (auto unused : state) benchmark::DoNotOptimize(is_hidden(scene.points[next++ % scene.points.size()]));
}

void point_by_tree(benchmark::State& state) {
  const report::TriangleScene scene = scene_of(state);
  const ShadowTree tree(lamp, scene.blockers);
  ask(state, scene, [&](const Point3& p) { return tree.region_from(p); });
  std::size_t tests = 0;
  for (const Point3& p : scene.points) tests += tree.tests(p);
  state.counters["tests"] = static_cast<double>(tests) / static_cast<double>(scene.points.size());
  state.counters["nodes"] = static_cast<double>(tree.node_count());
  state.counters["height"] = static_cast<double>(tree.height());
}

void point_by_hierarchy(benchmark::State& state) {
  const report::TriangleScene scene = scene_of(state);
  FastPointVisibility fast(lamp, BlockerSet(scene.blockers));
  ask(state, scene, [&](const Point3& p) { return fast.region_from(p); });
}

void point_by_embree(benchmark::State& state) {
  const report::TriangleScene scene = scene_of(state);
  report::EmbreeRays rays(scene.blockers);
  ask(state, scene, [&](const Point3& p) {
    const Point3& l = lamp.position;
    return rays.is_hidden(p, {l.x - p.x, l.y - p.y, l.z - p.z});
  });
}

void tree_set_up(benchmark::State& state) {
  const report::TriangleScene scene = scene_of(state);
  for (auto unused : state) benchmark::DoNotOptimize(ShadowTree(lamp, scene.blockers).node_count());
}

const ConvexPolygon& ground() {
  static const ConvexPolygon polygon = ConvexPolygon::from_points({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
  return polygon;
}

void tree_pieces(benchmark::State& state) {
  const report::TriangleScene scene = scene_of(state);
  for (auto unused : state) {
    benchmark::DoNotOptimize(ShadowTree(lamp, scene.blockers).pieces(ground().points()).shadow.size());
  }
}

void tree_division(benchmark::State& state) {
  const report::TriangleScene scene = scene_of(state);
  const Light light = lamp;
  for (auto unused : state) {
    benchmark::DoNotOptimize(receiver_division(light, scene.blockers, {&ground(), 1}).front().faces().size());
  }
}

BENCHMARK(point_by_tree)->Arg(10)->Arg(100)->Arg(1000);
BENCHMARK(point_by_hierarchy)->Arg(10)->Arg(100)->Arg(1000);
BENCHMARK(point_by_embree)->Arg(10)->Arg(100)->Arg(1000);
BENCHMARK(tree_set_up)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(tree_pieces)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(tree_division)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

bool ratios_of(int n) {
  const std::string argument = '/' + std::to_string(n), triangles = ", " + std::to_string(n) + " triangles";
  return add_ratio({"point_by_tree" + argument, "point_by_hierarchy" + argument, 1, 1,
                    "a point behind a shadow tree / behind the hierarchy of boxes" + triangles}) &&
         add_ratio({"point_by_tree" + argument, "point_by_embree" + argument, 1, 0,
                    "the same / a shadow ray of Embree in floats" + triangles});
}

const bool trees_asked =
    ratios_of(10) && ratios_of(100) && ratios_of(1000) &&
    add_ratio({"tree_pieces/1000", "tree_division/1000", 1, 0,
               "a floor in pieces by a shadow tree, its making included / divided by events, 1000 triangles"});

}  // namespace
}  // namespace gnomon::benchmarks
