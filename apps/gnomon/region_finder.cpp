#include "apps/gnomon/region_finder.h"

#include <memory>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/element_choice.h"
#include "geometry/scene/convex_parts.h"

namespace gnomon {
namespace {

/// The lights of that name, or all of them.
template <class SomeLight>
std::vector<const SomeLight*> chosen_lights(const std::vector<SomeLight>& lights, const std::string& name) {
  require_name("--light", "light", name, lights);
  std::vector<const SomeLight*> chosen;
  for (const SomeLight& light : lights) {
    if (name.empty() || light.name == name) chosen.push_back(&light);
  }
  return chosen;
}

Obstacles obstacles_of(const std::vector<SceneBlocker>& blockers) {
  Obstacles obstacles;
  for (const SceneBlocker& blocker : blockers) {
    for (ConvexPart& part : convex_parts(blocker)) obstacles.blockers.push_back(std::move(part.shape));
    if (auto space = enclosed_space(blocker)) obstacles.enclosures.push_back(std::move(*space));
  }
  return obstacles;
}

RegionFinder spatial_finder(const Scene& scene, const std::string& light) {
  const std::vector<const SceneLight*> lights = chosen_lights(scene.lights, light);
  RegionFinder finder;
  for (const SceneLight* l : lights) finder.lights.push_back(l->name);
  const auto obstacles = std::make_shared<const Obstacles>(obstacles_of(scene.blockers));
  finder.at = [lights, obstacles](const std::array<double, 3>& p) {
    std::vector<Visibility> seen;
    for (const SceneLight* l : lights) seen.push_back(exact_visibility(l->shape, *obstacles, {p[0], p[1], p[2]}));
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
