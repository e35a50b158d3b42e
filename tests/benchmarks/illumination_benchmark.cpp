#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "gnomon/illumination.h"
#include "gnomon/scene.h"
#include "tests/benchmarks/ratios.h"

// Meshes of the receivers of scenes: how many faces a tolerance takes, and what irradiance costs at a place once there
// is a mesh, beside asking behind the obstacles.
namespace gnomon::benchmarks {
namespace {

struct LitReceivers {
  std::vector<IlluminationLight> lights;
  Obstacles obstacles;
  std::vector<ConvexPolygon> receivers;
};

LitReceivers lit_receivers(const std::string& example) {
  const Scene scene = read_scene(std::string(GNOMON_EXAMPLES "/") + example + ".scene.json");
  const auto& space = std::get<SpaceScene>(scene);
  LitReceivers found;
  found.obstacles = scene_bodies(space).obstacles;
  for (const SceneLight& light : space.lights) found.lights.push_back({{light.shape}, light.strength});
  for (const SceneReceiver& receiver : space.receivers) found.receivers.push_back(receiver.shape);
  return found;
}

/// The tolerance is 10^-range(1) of the largest irradiance.
IlluminationEffort effort_of(const benchmark::State& state) {
  IlluminationEffort effort;
  effort.order = static_cast<int>(state.range(0));
  effort.tolerance = std::pow(10, -static_cast<double>(state.range(1)));
  return effort;
}

void illuminated_boxes(benchmark::State& state) {
  const LitReceivers boxes = lit_receivers("boxes");
  Illumination found;
  for (auto unused : state) found = illuminate(boxes.lights, boxes.obstacles, boxes.receivers, effort_of(state));
  double faces = 0, unmet = 0;
  for (const IlluminationMesh& mesh : found.meshes) {
    faces += static_cast<double>(mesh.faces.size());
    unmet += static_cast<double>(mesh.unmet_faces());
  }
  state.counters["faces"] = faces;
  state.counters["unmet"] = unmet;
  state.counters["evaluations"] = static_cast<double>(found.evaluations);
}

/// Places of the floor of Boxes, in no order.
std::vector<Point3> floor_places(const LitReceivers& boxes) {
  std::mt19937 engine(1);
  const auto points = boxes.receivers.front().points();
  std::uniform_real_distribution<double> x(points[0].x, points[2].x), y(points[0].y, points[2].y);
  std::vector<Point3> places;
  for (int i = 0; i < 4096; ++i) places.push_back({x(engine), y(engine), points[0].z});
  return places;
}

/// Of one place.
void irradiance_of_mesh(benchmark::State& state) {
  const LitReceivers boxes = lit_receivers("boxes");
  const Illumination found = illuminate(boxes.lights, boxes.obstacles, boxes.receivers, effort_of(state));
  const IlluminationField field(found.meshes.front());
  const std::vector<Point3> places = floor_places(boxes);
  std::size_t k = 0;
  for (auto unused : state) benchmark::DoNotOptimize(field.at(places[k++ % places.size()]));
  state.counters["faces"] = static_cast<double>(found.meshes.front().faces.size());
}

/// Of one place.
void irradiance_behind_boxes(benchmark::State& state) {
  const LitReceivers boxes = lit_receivers("boxes");
  LightIrradiance lamp(boxes.lights.front().parts.front(), boxes.lights.front().strength,
                       PreparedObstacles(boxes.obstacles));
  const std::vector<Point3> places = floor_places(boxes);
  std::size_t k = 0;
  for (auto unused : state) benchmark::DoNotOptimize(lamp.received({places[k++ % places.size()], {}}, {0, 0, 1}));
}

BENCHMARK(illuminated_boxes)->ArgsProduct({{1, 2}, {2, 3}})->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(irradiance_of_mesh)->ArgsProduct({{1, 2}, {2, 3}});
BENCHMARK(irradiance_behind_boxes);

const bool has_ratios = add_ratio({"irradiance_of_mesh/1/2", "irradiance_behind_boxes", 1, 0,
                                   "of asking behind the obstacles: a look-up in linear faces to 1e-2"}) &&
                        add_ratio({"irradiance_of_mesh/2/3", "irradiance_behind_boxes", 1, 0,
                                   "of asking behind the obstacles: a look-up in quadratic faces to 1e-3"});

}  // namespace
}  // namespace gnomon::benchmarks
