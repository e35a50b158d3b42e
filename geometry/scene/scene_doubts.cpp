#include "geometry/scene/scene_doubts.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <tuple>

#include "geometry/bodies/body.h"
#include "geometry/bodies/closed_surface.h"
#include "geometry/numbers/orientation.h"
#include "geometry/scene/json_text.h"
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

/// The lights of the file, each as its parts.
std::vector<std::span<const SceneLight>> light_elements(std::span<const SceneLight> lights) {
  std::vector<std::span<const SceneLight>> elements;
  for (std::size_t first = 0, last = 0; first < lights.size(); first = last) {
    while (last < lights.size() && lights[last].element == lights[first].element) ++last;
    elements.push_back(lights.subspan(first, last - first));
  }
  return elements;
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

bool is_inside(const Point3& p, const ConvexSolid& solid) {
  return std::ranges::all_of(solid.facets(), [&](const ConvexSolid::Facet& facet) {
    const auto corner = [&](std::size_t k) { return solid.points()[facet.loop[k]]; };
    return exact_orientation(corner(0), corner(1), corner(2), p) < 0;
  });
}

bool is_in_box_of(const Point3& p, std::span<const Point3> points) {
  return std::ranges::all_of(std::array{&Point3::x, &Point3::y, &Point3::z}, [&](double Point3::*c) {
    return std::ranges::any_of(points, [&](const Point3& q) { return q.*c < p.*c; }) &&
           std::ranges::any_of(points, [&](const Point3& q) { return q.*c > p.*c; });
  });
}

/// What a blocker that fills the space around some of the points is called.
std::string filling(const SceneBlocker& blocker, std::span<const Point3> points) {
  const Mesh* mesh = std::get_if<Mesh>(&blocker.shape);
  const bool may_fill = mesh ? mesh->closed : std::holds_alternative<Polytope>(blocker.shape);
  const auto corners = blocker_points(blocker.shape);
  const auto is_near = [&](const Point3& p) { return is_in_box_of(p, corners); };
  if (!may_fill || std::ranges::none_of(points, is_near)) return "";
  if (const auto space = enclosed_space(blocker)) {
    const bool is_filled = std::ranges::any_of(points, [&](const Point3& p) { return is_strictly_inside(p, *space); });
    return is_filled ? "a closed mesh" : "";
  }
  for (const ConvexPart& part : convex_parts(blocker)) {
    const auto* solid = std::get_if<ConvexSolid>(&part.shape);
    if (solid && std::ranges::any_of(points, [&](const Point3& p) { return is_inside(p, *solid); })) return "a solid";
  }
  return "";
}

/// A room as a closed mesh is a solid to the program, and dark.
void doubt_enclosed_lights(const SpaceScene& scene, std::vector<std::string>& doubts) {
  for (const auto parts : light_elements(scene.lights)) {
    if (std::holds_alternative<DirectionalLight>(parts[0].shape)) continue;
    std::vector<Point3> points;
    for (const SceneLight& part : parts) {
      for (const Point3& p : light_points(part.shape)) points.push_back(p);
    }
    for (const SceneBlocker& blocker : scene.blockers) {
      const std::string what = filling(blocker, points);
      if (what.empty()) continue;
      doubts.push_back(
          element_title("lights", parts[0].element) + ": it reaches into " + element_title("blockers", blocker.name) +
          ", " + what +
          ": all inside is in the umbra, and what of the light is there shines nowhere; leave out a facet, "
          "or write walls as polygons, for a room with air in it");
    }
  }
}

template <class SomeScene>
std::vector<std::string> doubts_of_lists(const SomeScene& scene) {
  std::vector<std::string> doubts;
  if (scene.lights.empty()) doubts.emplace_back("the scene has no light");
  if (scene.blockers.empty()) doubts.emplace_back("the scene has no blocker");
  doubt_darkness(scene.lights, doubts);
  doubt_duplicates(scene.blockers, doubts);
  return doubts;
}

}  // namespace

std::vector<std::string> scene_doubts(const PlaneScene& scene) {
  return doubts_of_lists(scene);
}

std::vector<std::string> scene_doubts(const SpaceScene& scene) {
  std::vector<std::string> doubts = doubts_of_lists(scene);
  doubt_backs(scene, doubts);
  doubt_dark_receivers(scene, doubts);
  doubt_enclosed_lights(scene, doubts);
  doubt_materials(scene, doubts);
  return doubts;
}

}  // namespace gnomon
