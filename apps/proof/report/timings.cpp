#include "apps/proof/report/timings.h"
#include "apps/proof/report/reflection_peers.h"
#include "apps/proof/report/table_one.h"

#include <utility>

#include "apps/proof/report/box_stacks.h"
#include "apps/proof/report/plain_walk.h"
#include "apps/proof/report/polygon_pairs.h"
#include "apps/proof/report/spheres.h"
#include "apps/proof/report/triangle_scenes.h"
#include "gnomon/pair.h"
#include "gnomon/receiver_mesh.h"
#include "gnomon/shadow_mesh.h"
#include "gnomon/visibility.h"
#include "shading/lambert.h"

namespace gnomon::report {
namespace {

using Timings = std::vector<Timing>;

constexpr ShadowParts timed_parts{.penumbra = false, .cells = false, .planes = false, .volumes = false};

/// About a pair and some of its shadow; nothing is aligned with it.
constexpr Box3 timed_box{{-9.1, -8.7, -9.3}, {8.9, 9.2, 9.4}};

/// Done so often in a row that calling and asking the clock do not count.
constexpr std::size_t in_a_row = 64;

Care care(Effort effort) {
  return effort == Effort::quick ? Care{3, 0.005} : Care{5, 0.05};
}

template <class Way>
Timing timed_short(const char* task, std::size_t size, Effort effort, Way way) {
  const auto pass = [&] {
    for (std::size_t i = 0; i < in_a_row; ++i) way();
  };
  return {task, size, time_per_result(pass, in_a_row, care(effort))};
}

template <class Way>
Timing timed(const char* task, std::size_t size, Effort effort, Way way) {
  return {task, size, time_per_result([&] { way(); }, 1, care(effort))};
}

/// Done once, its time taken and its memory as well. `way` returns a count.
template <class Way>
Timing once(const char* task, std::size_t size, Way way) {
  Timing result{task, size};
  result.memory = memory_growth([&] {
    const double start = thread_seconds();
    result.count = way();
    result.seconds = seconds_of({thread_seconds() - start});
  });
  return result;
}

Timings planes(Effort effort) {
  Timings all;
  for (const std::uint32_t n : {3U, 4U, 16U, 256U, 1024U}) {
    const PolygonPair pair = generic_pair(n);
    const auto& light = std::get<AreaLight>(pair.light);
    all.push_back(timed_short("exact_planes", n, effort, [&] { extremal_planes(pair.light, pair.blocker); }));
    all.push_back(timed_short("plain_planes", n, effort, [&] { plain_extremal_planes(light, pair.blocker); }));
  }
  return all;
}

Timings meshes(Effort effort) {
  Timings all;
  for (const std::uint32_t n : {4U, 64U, 1024U}) {
    const PolygonPair pair = generic_pair(n);
    const ConvexBlocker blocker = pair.blocker;
    all.push_back(timed("meshes", n, effort, [&] { shadow_meshes(pair.light, blocker, timed_box, timed_parts); }));
  }
  const Light lamp = lamp_above_sphere();
  const ConvexBlocker solid = sphere(1000);
  all.push_back(timed("solid_meshes", 1000, effort, [&] { shadow_meshes(lamp, solid, timed_box, timed_parts); }));
  return all;
}

Timings mesh_parts(Effort effort) {
  const Light lamp = lamp_above_sphere();
  const std::vector<ConvexBlocker> parts = sphere_facets(5000);
  const auto way = [&] {
    std::vector<ShadowMeshes> all;
    for (const ConvexBlocker& part : parts) all.push_back(shadow_meshes(lamp, part, timed_box, timed_parts));
    return all.size();
  };
  Timing result = once("mesh_parts", parts.size(), way);
  result.seconds = timed("mesh_parts", parts.size(), effort, way).seconds;
  return {result};
}

Timings lambert_quad(Effort effort) {
  const TriangleScene scene = triangle_scene(1);
  FastVisibility visibility(scene.light, BlockerSet({}));
  const std::optional<VisibleAreaLight> seen = visibility.visible_from(scene.points.front());
  if (!seen) return {};
  return {timed_short("lambert_quad", 1, effort, [&] { lambert_irradiance(*seen, {0, 0, 1}, 1); })};
}

Timings random_points() {
  constexpr std::size_t in_each = 10000;
  std::size_t points = 0;
  const auto left_to_exact_level = [&] {
    std::size_t left = 0;
    for (const std::size_t n : {1U, 4U, 16U, 64U}) {
      const TriangleScene scene = triangle_scene(n, in_each);
      LightVisibility level(scene.light, PreparedObstacles(Obstacles{scene.blockers, {}}));
      for (const Point3& p : scene.points) level.at(p);
      left += level.exact_answers();
      points += in_each;
    }
    return left;
  };
  Timing result = once("random_points", 0, left_to_exact_level);
  result.size = points;
  return {result};
}

Timings set_up() {
  constexpr std::size_t triangles = 100000;
  return {once("set_up", triangles, [] {
    const TriangleScene scene = triangle_scene(triangles, 1);
    FastVisibility visibility(scene.light, BlockerSet(scene.blockers));
    return visibility.visible_from(scene.points.front()) ? 0U : 1U;
  })};
}

std::size_t faces(const Light& light, const BoxStacks& stacks) {
  std::size_t count = 0;
  const ReceiverDivision division(light, stacks.boxes, stacks.receivers);
  for (std::uint32_t r = 0; r < division.size(); ++r) count += division.mesh(r).faces().size();
  return count;
}

/// k by k stacks of boxes, all faces of which are receivers.
Timings stacks(std::size_t k) {
  const BoxStacks all = box_stacks(k);
  const std::size_t receivers = all.receivers.size();
  return {once("hexagon_stacks", receivers, [&] { return faces(distant_hexagon(k), all); }),
          once("square_stacks", receivers, [&] { return faces(square_above(k), all); })};
}

}  // namespace

std::vector<TimingTask> timing_tasks(Effort effort) {
  std::vector<TimingTask> tasks = {{"extremal planes", [=] { return planes(effort); }},
                                   {"meshes", [=] { return meshes(effort); }},
                                   {"a mesh part by part", [=] { return mesh_parts(effort); }},
                                   {"a square in full view", [=] { return lambert_quad(effort); }},
                                   {"what a floor reflects", [=] { return reflection_timings(effort); }},
                                   {"points on lights with Embree's rays", [=] { return reflection_peers(effort); }},
                                   {"random points", random_points},
                                   {"many triangles", set_up}};
  if (effort == Effort::quick) return tasks;
  tasks.push_back({"a picture of a sphere", [] { return Timings{{"sphere_picture", 512, sphere_picture(512)}}; }});
  for (const std::size_t k : {2U, 5U, 8U}) {
    tasks.push_back({std::to_string(k) + " by " + std::to_string(k) + " stacks", [=] { return stacks(k); }});
  }
  return tasks;
}

}  // namespace gnomon::report
