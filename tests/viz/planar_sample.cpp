#include "tests/viz/planar_sample.h"

#include <utility>

namespace gnomon {

PlanarSample::PlanarSample() {
  scene_.source = "planar_sample.scene.json";
  scene_.dimension = 2;
  scene_.planar_lights.push_back({"tube", {{-0.5, 4}, {0.5, 4}}, 1});
  scene_.planar_blockers.push_back({"wall", {{-1, 2}, {1, 2}}});
  scene_.planar_receivers.push_back({"floor", {{-4, 0}, {4, 0}}});
  result_.scene = &scene_;
  result_.clip_box = {{-5, -1, 0}, {5, 5, 0}};

  planar::ShadowRegions regions = planar::shadow_regions(
      planar::Pair::from_points(scene_.planar_lights[0].vertices, scene_.planar_blockers[0].vertices));
  planar::ShadowRegionsInBox in_box = planar::regions_in_box(regions, {{-5, -1}, {5, 5}});
  result_.planar_pairs.push_back({0, 0, "tube", "wall", Position::standard, std::move(regions), std::move(in_box)});
}

}  // namespace gnomon
