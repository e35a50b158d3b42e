#include "tests/viz/planar_sample.h"

#include <utility>

namespace gnomon {

PlanarSample::PlanarSample() {
  auto& scene = scene_.emplace<PlaneScene>();
  scene.source = "planar_sample.scene.json";
  scene.lights.push_back({"tube", {{-0.5, 4}, {0.5, 4}}, 1});
  scene.blockers.push_back({"wall", {{-1, 2}, {1, 2}}});
  scene.receivers.push_back({"floor", {{-4, 0}, {4, 0}}});
  result_.scene = &scene_;
  result_.clip_box = {{-5, -1, 0}, {5, 5, 0}};

  planar::ShadowRegions regions =
      planar::shadow_regions(planar::Pair::from_points(scene.lights[0].vertices, scene.blockers[0].vertices));
  planar::ShadowRegionsInBox in_box = planar::regions_in_box(regions, {{-5, -1}, {5, 5}});
  result_.planar_pairs.push_back({0, 0, "tube", "wall", Position::standard, std::move(regions), std::move(in_box)});
}

}  // namespace gnomon
