#include "apps/gnomon/region_finder.h"

#include <memory>

#include "apps/gnomon/element_choice.h"
#include "apps/gnomon/planar_sight.h"
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

Visibility visibility_in_plane(const planar::Sight& sight, const Point2& p) {
  const planar::VisibleLight seen = sight.visible_light(p);
  const planar::VisibleFraction fraction = visible_fraction(seen);
  return {seen.region, fraction.value, fraction.error};
}

RegionFinder planar_finder(const Scene& scene, const std::string& light) {
  const auto sights = std::make_shared<std::vector<planar::Sight>>();
  RegionFinder finder;
  for (const PlanarLight* l : chosen_lights(scene.planar_lights, light)) {
    finder.lights.push_back(l->name);
    sights->push_back(planar_sight(scene, *l));
  }
  finder.at = [sights](const std::array<double, 3>& p) {
    std::vector<Visibility> seen;
    for (const planar::Sight& sight : *sights) seen.push_back(visibility_in_plane(sight, {p[0], p[1]}));
    return seen;
  };
  return finder;
}

}  // namespace

RegionFinder region_finder(const Scene& scene, const std::string& light) {
  if (scene.dimension == 3) return spatial_finder(scene, light);
  return planar_finder(scene, light);
}

}  // namespace gnomon
