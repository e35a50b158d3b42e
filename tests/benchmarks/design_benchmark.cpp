#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <random>

#include "gnomon/light_design.h"
#include "shading/inverse/feasible_region.h"
#include "shading/inverse/goal_sets.h"
#include "tests/benchmarks/ratios.h"

// A point light in a box above flat blockers, with dark and lit goals made of what a light does that stands there: how
// long the planes take, the cells, the choice of one, the nearest, and looking at all goals from the light's side.
namespace gnomon::benchmarks {
namespace {

/// `dark` goals by one blocker each, `lit` goals, behind five blockers of `vertices` corners.
struct DesignScene {
  Design design;
  DesignObstacles obstacles;
};

ConvexPolygon regular_polygon(const Point3& centre, double radius, int vertices) {
  std::vector<Point3> points;
  for (int k = 0; k < vertices; ++k) {
    const double a = 2 * std::numbers::pi * k / vertices;
    points.push_back({centre.x + radius * std::cos(a), centre.y + radius * std::sin(a), centre.z});
  }
  return ConvexPolygon::from_points(points);
}

DesignScene scene_of(const benchmark::State& state) {
  constexpr int blockers = 5;
  const int dark = static_cast<int>(state.range(0)), lit = static_cast<int>(state.range(1));
  const int vertices = static_cast<int>(state.range(2));
  std::mt19937 engine(27);
  std::uniform_real_distribution<double> spread(-4, 4);
  const Point3 lamp = {0.3, -0.2, 9};
  DesignScene scene;
  for (int b = 0; b < blockers; ++b) {
    const Point3 centre = {spread(engine), spread(engine), 4 + 0.25 * b};
    scene.obstacles.obstacles.blockers.emplace_back(regular_polygon(centre, 1.2, vertices));
    scene.obstacles.parts.push_back("b" + std::to_string(b));
  }
  scene.obstacles.elements = scene.obstacles.parts;
  scene.design.domain = {DomainShape::box, {{-4, -4, 7}, {4, 4, 11}}};
  // A point in the shadow of a blocker's middle; and points that the lamp lights.
  for (int g = 0; g < dark + lit;) {
    DesignGoal goal;
    goal.name = "g" + std::to_string(g);
    Point3 q = {2 * spread(engine), 2 * spread(engine), 0};
    if (g < dark) {
      const auto& polygon =
          std::get<ConvexPolygon>(scene.obstacles.obstacles.blockers[static_cast<std::size_t>(g % blockers)]);
      const Point3 m = {polygon.points()[0].x - 1.2 + 0.1 * spread(engine), polygon.points()[0].y,
                        polygon.points()[0].z};
      const double t = lamp.z / (lamp.z - m.z);
      q = {lamp.x + t * (m.x - lamp.x), lamp.y + t * (m.y - lamp.y), 0};
      goal.want = Want::dark;
      goal.by = "b" + std::to_string(g % blockers);
    }
    goal.subjects = {{{q}, {}}};
    const bool is_lit = exact_visibility(PointLight{lamp}, scene.obstacles.obstacles, q).region == Region::lit;
    if (g >= dark && !is_lit) continue;
    scene.design.goals.push_back(goal);
    ++g;
  }
  return scene;
}

void design_planes(benchmark::State& state) {
  const DesignScene scene = scene_of(state);
  for (auto unused : state) {
    inverse::DesignSpace space;
    for (std::uint32_t g = 0; g < scene.design.goals.size(); ++g) {
      benchmark::DoNotOptimize(goal_sets(space, scene.design, g, scene.obstacles).none.size());
    }
  }
}

void design_cells(benchmark::State& state) {
  const DesignScene scene = scene_of(state);
  inverse::DesignSpace space;
  std::vector<inverse::GoalSets> goals;
  for (std::uint32_t g = 0; g < scene.design.goals.size(); ++g)
    goals.push_back(goal_sets(space, scene.design, g, scene.obstacles));
  std::size_t cells = 0;
  for (auto unused : state) {
    inverse::DesignSpace copy = space;
    cells = feasible_cells(copy, scene.design.domain, goals, {}).cells.size();
  }
  state.counters["cells"] = static_cast<double>(cells);
}

void solve(benchmark::State& state, const DesignEffort& effort) {
  const DesignScene scene = scene_of(state);
  for (auto unused : state) {
    const DesignResult result = solved_design(scene.design, scene.obstacles, effort);
    if (!result.answer) return state.SkipWithError("there is no answer");
  }
}

void design_centre(benchmark::State& state) {
  solve(state, {});
}

void design_nearest(benchmark::State& state) {
  solve(state, {.choice = Choice::nearest, .near = Point3{9, 9, 9}});
}

void design_check(benchmark::State& state) {
  const DesignScene scene = scene_of(state);
  for (auto unused : state) {
    benchmark::DoNotOptimize(checked_design(scene.design, scene.obstacles, {0.3, -0.2, 9}).goals.size());
  }
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->Args({5, 5, 20})->Args({5, 5, 4})->Args({3, 20, 8})->Args({3, 60, 8})->Unit(benchmark::kMillisecond);
}

BENCHMARK(design_planes)->Apply(sizes);
BENCHMARK(design_cells)->Apply(sizes);
BENCHMARK(design_centre)->Apply(sizes);
BENCHMARK(design_nearest)->Apply(sizes);
BENCHMARK(design_check)->Apply(sizes);

}  // namespace
}  // namespace gnomon::benchmarks
