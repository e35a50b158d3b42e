#include "apps/gnomon/region_finder.h"

#include <memory>

#include "apps/gnomon/element_choice.h"
#include "apps/gnomon/light_groups.h"
#include "geometry/parallel.h"
#include "gnomon/light_parts.h"
#include "gnomon/scene.h"
#include "gnomon/visibility.h"

namespace gnomon {
namespace {

RegionFinder finder_of(const SpaceScene& scene, const std::string& light, unsigned threads,
                       const LinearSearch& search) {
  const std::vector<LightGroup> groups = chosen_groups(scene, light);
  RegionFinder finder;
  finder.threads = threads;
  finder.lights = names_of(groups);
  const PreparedObstacles obstacles(scene_bodies(scene).obstacles);
  const auto of_workers = std::make_shared<std::vector<std::vector<PartsVisibility>>>(threads);
  for (std::vector<PartsVisibility>& own : *of_workers) {
    for (const LightGroup& group : groups) own.emplace_back(shapes_of(group), obstacles, search);
  }
  finder.at = [of_workers](std::size_t worker, const std::array<double, 3>& p) {
    std::vector<Visibility> seen;
    for (PartsVisibility& visible_light : (*of_workers)[worker]) seen.push_back(visible_light.at({p[0], p[1], p[2]}));
    return seen;
  };
  finder.received = [of_workers, obstacles](std::size_t worker, const std::array<double, 3>& p,
                                            const std::array<double, 3>& n) {
    const ReceiverPoint receiver = resting_point(obstacles, {p[0], p[1], p[2]}, {n[0], n[1], n[2]});
    std::vector<Visibility> seen;
    for (PartsVisibility& visible_light : (*of_workers)[worker]) seen.push_back(visible_light.received(receiver));
    return seen;
  };
  finder.is_within_rounding = [obstacles](const std::array<double, 3>& p) {
    return is_within_rounding(obstacles, {p[0], p[1], p[2]});
  };
  return finder;
}

Visibility visibility_in_plane(const planar::LightVisibility& visibility, const Point2& p) {
  const planar::VisibleLight seen = visibility.visible_light(p);
  const planar::VisibleFraction fraction = visible_fraction(seen);
  return {seen.region, fraction.value, fraction.error};
}

RegionFinder finder_of(const PlaneScene& scene, const std::string& light, unsigned threads, const LinearSearch&) {
  const auto visibilities = std::make_shared<std::vector<planar::LightVisibility>>();
  RegionFinder finder;
  finder.threads = threads;
  for (const PlanarLight* l : chosen_lights(scene.lights, light)) {
    finder.lights.push_back(l->name);
    visibilities->push_back(planar_visibility(scene, *l));
  }
  finder.at = [visibilities](std::size_t, const std::array<double, 3>& p) {
    std::vector<Visibility> seen;
    for (const planar::LightVisibility& visibility : *visibilities)
      seen.push_back(visibility_in_plane(visibility, {p[0], p[1]}));
    return seen;
  };
  return finder;
}

}  // namespace

RegionFinder region_finder(const Scene& scene, const std::string& light, unsigned threads, const LinearSearch& search) {
  return std::visit([&](const auto& some) { return finder_of(some, light, thread_count(threads), search); }, scene);
}

}  // namespace gnomon
