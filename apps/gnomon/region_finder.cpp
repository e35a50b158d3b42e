#include "apps/gnomon/region_finder.h"

#include <tbb/enumerable_thread_specific.h>

#include <memory>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/element_choice.h"
#include "apps/gnomon/scene_obstacles.h"
#include "geometry/visibility/light_visibility.h"

namespace gnomon {
namespace {

RegionFinder spatial_finder(const Scene& scene, const std::string& light) {
  const std::vector<const SceneLight*> lights = chosen_lights(scene.lights, light);
  RegionFinder finder;
  for (const SceneLight* l : lights) finder.lights.push_back(l->name);
  const PreparedObstacles obstacles = scene_obstacles(scene);
  const auto per_thread = std::make_shared<tbb::enumerable_thread_specific<std::vector<LightVisibility>>>([=] {
    std::vector<LightVisibility> result;
    for (const SceneLight* l : lights) result.emplace_back(l->shape, obstacles);
    return result;
  });
  finder.at = [per_thread](const std::array<double, 3>& p) {
    std::vector<Visibility> seen;
    for (LightVisibility& light_seen : per_thread->local()) seen.push_back(light_seen.at({p[0], p[1], p[2]}));
    return seen;
  };
  return finder;
}

}  // namespace

RegionFinder region_finder(const Scene& scene, const std::string& light) {
  if (scene.dimension == 3) return spatial_finder(scene, light);
  throw UnsupportedError(scene.source + ": regions of scenes of dimension 2 are not available in this version");
}

}  // namespace gnomon
