#include "geometry/scene/scene_doubts.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include "geometry/numbers/orientation.h"
#include "geometry/scene/json_text.h"
#include "geometry/scene/lights_in_solids.h"
#include "geometry/scene/receiver_facets.h"
#include "geometry/scene/scene_points.h"
#include "geometry/scene/surface_reader.h"

namespace gnomon {
namespace {

/// Vertices in an order of their own, so that equal sets compare equal. The kind of shape comes first.
using VertexSet = std::pair<std::size_t, std::vector<std::array<double, 3>>>;

VertexSet vertex_set(const SceneBlocker& blocker) {
  VertexSet set{blocker.shape.index(), {}};
  for (const Point3& p : blocker_points(blocker.shape)) set.second.push_back({p.x, p.y, p.z});
  std::sort(set.second.begin(), set.second.end());
  return set;
}

VertexSet vertex_set(const PlanarBlocker& blocker) {
  VertexSet set;
  for (const Point2& p : blocker.vertices) set.second.push_back({p.x, p.y, 0});
  // A chain is the same backwards, but not in another order.
  if (set.second.back() < set.second.front()) std::reverse(set.second.begin(), set.second.end());
  return set;
}

template <class Blocker>
void doubt_duplicates(const std::vector<Blocker>& blockers, std::vector<std::string>& doubts) {
  std::map<VertexSet, std::string> known;
  for (const Blocker& blocker : blockers) {
    const auto [first, is_new] = known.try_emplace(vertex_set(blocker), blocker.name);
    if (is_new) continue;
    doubts.push_back(element_title("blockers", blocker.name) + ": its vertices are those of " +
                     element_title("blockers", first->second));
  }
}

void doubt_strength(const std::string& light, double strength, std::vector<std::string>& doubts) {
  if (strength > 0) return;
  doubts.push_back(element_title("lights", light) + ": its strength is 0; its shadows are computed all the same");
}

void doubt_darkness(const std::vector<PlanarLight>& lights, std::vector<std::string>& doubts) {
  for (const PlanarLight& light : lights) doubt_strength(light.name, light.strength, doubts);
}

void doubt_darkness(const std::vector<SceneLight>& lights, std::vector<std::string>& doubts) {
  for (const auto parts : light_elements(lights)) doubt_strength(parts[0].element, parts[0].strength, doubts);
}

bool reaches_front(std::span<const Point3> points, const ConvexPolygon& light) {
  const auto corner = [&](std::size_t k) { return light.points()[light.corners()[k]]; };
  return std::any_of(points.begin(), points.end(),
                     [&](const Point3& p) { return exact_orientation(corner(0), corner(1), corner(2), p) > 0; });
}

/// True of a one-sided flat light that has no blocker in front of it.
bool turns_its_back(const SceneLight& light, const std::vector<SceneBlocker>& blockers) {
  const auto* area = std::get_if<AreaLight>(&light.shape);
  if (!area || area->two_sided || !area->polygon.is_flat()) return false;
  return std::none_of(blockers.begin(), blockers.end(), [&](const SceneBlocker& blocker) {
    return reaches_front(blocker_points(blocker.shape), area->polygon);
  });
}

void doubt_backs(const SpaceScene& scene, std::vector<std::string>& doubts) {
  if (scene.blockers.empty()) return;
  for (const auto parts : light_elements(scene.lights)) {
    const auto turns = [&](const SceneLight& part) { return turns_its_back(part, scene.blockers); };
    if (!std::all_of(parts.begin(), parts.end(), turns)) continue;
    doubts.push_back(element_title("lights", parts[0].element) +
                     ": no blocker is in front of it; a polygon light shines to the side from which its vertices run "
                     "counterclockwise");
  }
}

/// What stands against a light's reaching a facet, the worst first.
enum class Reach { light_is_behind, light_grazes, light_turns_its_back, reaches };

/// Whether something of a light lies strictly before a facet, and an area light shows it its face.
struct ReachOf {
  const ConvexPolygon& facet;

  Reach operator()(const PointLight& light) const { return reach(side(light.position)); }
  Reach operator()(const DirectionalLight& light) const {
    const Point3& d = light.direction;
    return reach(exact_direction_side(corner(0), corner(1), corner(2), {-d.x, -d.y, -d.z}));
  }
  Reach operator()(const LinearLight& light) const { return reach(std::max(side(light.start), side(light.end))); }
  Reach operator()(const AreaLight& light) const {
    int most = -1;
    for (const Point3& p : light.polygon.points()) most = std::max(most, side(p));
    if (most <= 0) return reach(most);
    const bool shows_face = light.two_sided || !light.polygon.is_flat() || reaches_front(facet.points(), light.polygon);
    return shows_face ? Reach::reaches : Reach::light_turns_its_back;
  }

  static Reach reach(int side) {
    return side > 0 ? Reach::reaches : side == 0 ? Reach::light_grazes : Reach::light_is_behind;
  }
  const Point3& corner(std::size_t k) const { return facet.points()[facet.corners()[k]]; }
  int side(const Point3& p) const { return exact_orientation(corner(0), corner(1), corner(2), p); }
};

std::string text_of_dark(Reach reach, bool two_sided) {
  if (reach == Reach::light_turns_its_back) {
    return ": no light shines on it; a polygon light before it turns its back, and shines to the side from which its "
           "vertices run counterclockwise, to both with \"two_sided\": true";
  }
  if (two_sided) return ": no light shines on either side of it";
  if (reach == Reach::light_grazes) {
    return ": no light is before it; one lies in its plane, and what comes along a plane does not light it";
  }
  return ": it is turned from every light; a receiver receives from the side from which its vertices run "
         "counterclockwise, from both with \"two_sided\": true";
}

/// Receivers of which no facet can receive anything. Of one with two sides one may well be dark.
void doubt_dark_receivers(const SpaceScene& scene, std::vector<std::string>& doubts) {
  if (scene.lights.empty()) return;
  for (const ReceiverGroup receiver : receiver_elements(scene.receivers)) {
    Reach most = Reach::light_is_behind;
    for (const SceneReceiver& facet : receiver) {
      for (const SceneLight& light : scene.lights) most = std::max(most, std::visit(ReachOf{facet.shape}, light.shape));
    }
    if (most == Reach::reaches) continue;
    const bool two_sided = receiver.front().side != receiver.back().side;
    doubts.push_back(element_title("receivers", receiver.front().element) + text_of_dark(most, two_sided));
  }
}

/// Materials are of the blocker where receiver and blocker are one surface.
void doubt_two_materials(const SpaceScene& scene, std::vector<std::string>& doubts) {
  using Places = std::set<std::array<double, 3>>;
  const auto add = [](Places& places, std::span<const Point3> points) {
    for (const Point3& p : points) places.insert({p.x, p.y, p.z});
  };
  std::map<Places, const SceneBlocker*> blockers;
  for (const SceneBlocker& blocker : scene.blockers) {
    Places places;
    add(places, blocker_points(blocker.shape));
    blockers.try_emplace(std::move(places), &blocker);
  }
  for (const ReceiverGroup receiver : receiver_elements(scene.receivers)) {
    Places places;
    for (const SceneReceiver& facet : receiver) add(places, facet.shape.points());
    const auto same = blockers.find(places);
    const std::string& material = receiver.front().material;
    if (same == blockers.end() || material.empty() || same->second->material == material) continue;
    doubts.push_back(element_title("receivers", receiver.front().element) + ": its vertices are those of " +
                     element_title("blockers", same->second->name) +
                     ", but not its material; 'gnomon image' shows the blocker's, all else tells of the receiver's");
  }
}

template <class SomeScene>
std::vector<std::string> doubts_of_blockers(const SomeScene& scene) {
  std::vector<std::string> doubts;
  if (scene.blockers.empty()) doubts.emplace_back("the scene has no blocker");
  doubt_duplicates(scene.blockers, doubts);
  return doubts;
}

template <class SomeScene>
std::vector<std::string> doubts_of_lights(const SomeScene& scene) {
  std::vector<std::string> doubts;
  if (scene.lights.empty()) doubts.emplace_back("the scene has no light");
  doubt_darkness(scene.lights, doubts);
  return doubts;
}

}  // namespace

std::vector<std::string> scene_doubts(const PlaneScene& scene) {
  return doubts_of_blockers(scene);
}

std::vector<std::string> scene_doubts(const SpaceScene& scene) {
  return doubts_of_blockers(scene);
}

std::vector<std::string> lighting_doubts(const PlaneScene& scene) {
  return doubts_of_lights(scene);
}

std::vector<std::string> lighting_doubts(const SpaceScene& scene) {
  std::vector<std::string> doubts = doubts_of_lights(scene);
  doubt_backs(scene, doubts);
  doubt_dark_receivers(scene, doubts);
  doubt_lights_in_solids(scene, doubts);
  doubt_two_materials(scene, doubts);
  doubt_materials(scene, doubts);
  return doubts;
}

}  // namespace gnomon
