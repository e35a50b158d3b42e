#include <benchmark/benchmark.h>

#include <string>
#include <utility>

#include "gnomon/scene.h"
#include "shading/image/shaded_image.h"
#include "tests/benchmarks/ratios.h"

namespace gnomon {
namespace {

void paint(benchmark::State& state, const SpaceScene& scene, std::uint32_t points) {
  const image::ImageOptions options{.points = points, .threads = 1};
  for (auto unused : state) benchmark::DoNotOptimize(image::shaded_image(scene, options, [](std::size_t) {}));
}

/// The Cornell box, 512 by 512 pixels, on one thread. The argument: so many points for its lamp; 0: the lamp itself.
void image_cornell_box(benchmark::State& state) {
  auto scene = std::get<SpaceScene>(read_scene(GNOMON_EXAMPLES "/cornell_box.scene.json"));
  scene.camera = SceneCamera{{278, 274, -811}, {278, 274, 280}, {0, 1, 0}, 39, 512, 512};
  paint(state, scene, static_cast<std::uint32_t>(state.range(0)));
}

/// A floor of 64 by 64 pixels in full view of so many lamps.
void image_lights_in_view(benchmark::State& state) {
  SpaceScene scene;
  for (int k = 0; k < state.range(0); ++k) {
    const double x = 0.3 * k - 2;
    scene.lights.push_back(
        {"lamp " + std::to_string(k),
         AreaLight{ConvexPolygon::from_points({{x, -1, 4}, {x, 1, 4}, {x + .2, 1, 4}, {x + .2, -1, 4}})}});
  }
  const ConvexPolygon floor = ConvexPolygon::from_points({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}});
  scene.materials = {{"floor", {.specular = {.3, .3, .3}, .exponent = 50}}};
  scene.receivers.push_back({"floor", floor, "floor", "floor"});
  scene.receivers.back().material = "floor";
  scene.camera = SceneCamera{{0, -6, 3}, {0, 0, 0}, {0, 0, 1}, 40, 64, 64};
  paint(state, scene, 0);
}

BENCHMARK(image_cornell_box)->Arg(0)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK(image_lights_in_view)->RangeMultiplier(2)->Range(1, 16)->Unit(benchmark::kMillisecond);

const bool asked = benchmarks::add_ratio({"image_cornell_box/0", "image_cornell_box/16", 1, 2,
                                          "the Cornell box under its lamp, in units of 16 points for it"}) &&
                   benchmarks::add_ratio({"image_lights_in_view/16", "image_lights_in_view/8", 0.5, 1.1,
                                          "time per light of a picture of 16 in full view, against 8"});

}  // namespace
}  // namespace gnomon
