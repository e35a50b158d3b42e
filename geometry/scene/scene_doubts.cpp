#include "geometry/scene/scene_doubts.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "geometry/scene/json_text.h"
#include "geometry/scene/receiver_facets.h"
#include "geometry/scene/scene_points.h"
#include "geometry/spatial/orientation.h"

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

template <class Light>
void doubt_darkness(const std::vector<Light>& lights, std::vector<std::string>& doubts) {
  for (const Light& light : lights) {
    if (light.strength > 0) continue;
    doubts.push_back(element_title("lights", light.name) +
                     ": its strength is 0; its shadows are computed all the same");
  }
}

bool reaches_front(std::span<const Point3> points, const ConvexPolygon& light) {
  const auto corner = [&](std::size_t k) { return light.points()[light.corners()[k]]; };
  return std::any_of(points.begin(), points.end(),
                     [&](const Point3& p) { return exact_orientation(corner(0), corner(1), corner(2), p) > 0; });
}

void doubt_backs(const Scene& scene, std::vector<std::string>& doubts) {
  for (const SceneLight& light : scene.lights) {
    const auto* area = std::get_if<AreaLight>(&light.shape);
    if (!area || area->two_sided || !area->polygon.is_flat() || scene.blockers.empty()) continue;
    const auto in_front = [&](const SceneBlocker& b) { return reaches_front(blocker_points(b.shape), area->polygon); };
    if (std::any_of(scene.blockers.begin(), scene.blockers.end(), in_front)) continue;
    doubts.push_back(element_title("lights", light.name) +
                     ": no blocker is in front of it; a polygon light shines to the side from which its vertices run "
                     "counterclockwise");
  }
}

/// Whether something of a light lies strictly before a facet, and an area light shows it its face.
struct MayReach {
  const ConvexPolygon& facet;

  bool operator()(const PointLight& light) const { return is_before(light.position); }
  bool operator()(const DirectionalLight& light) const {
    const Point3& d = light.direction;
    return exact_direction_side(corner(0), corner(1), corner(2), {-d.x, -d.y, -d.z}) > 0;
  }
  bool operator()(const LinearLight& light) const { return is_before(light.start) || is_before(light.end); }
  bool operator()(const AreaLight& light) const {
    const std::span<const Point3> points = light.polygon.points();
    if (std::none_of(points.begin(), points.end(), [&](const Point3& p) { return is_before(p); })) return false;
    return light.two_sided || !light.polygon.is_flat() || reaches_front(facet.points(), light.polygon);
  }

  const Point3& corner(std::size_t k) const { return facet.points()[facet.corners()[k]]; }
  bool is_before(const Point3& p) const { return exact_orientation(corner(0), corner(1), corner(2), p) > 0; }
};

/// Receivers of which no facet can receive anything. Of one with two sides one may well be dark.
void doubt_dark_receivers(const Scene& scene, std::vector<std::string>& doubts) {
  if (scene.lights.empty()) return;
  const auto may_be_lit = [&](const SceneReceiver& facet) {
    return std::any_of(scene.lights.begin(), scene.lights.end(),
                       [&](const SceneLight& light) { return std::visit(MayReach{facet.shape}, light.shape); });
  };
  for (const ReceiverGroup receiver : receiver_elements(scene.receivers)) {
    const bool two_sided = receiver.front().side != receiver.back().side;
    if (two_sided || std::any_of(receiver.begin(), receiver.end(), may_be_lit)) continue;
    doubts.push_back(element_title("receivers", receiver.front().element) +
                     ": it is turned from every light; a receiver receives from the side from which its vertices run "
                     "counterclockwise, from both with \"two_sided\": true");
  }
}

}  // namespace

std::vector<std::string> scene_doubts(const Scene& scene) {
  std::vector<std::string> doubts;
  if (scene.lights.empty() && scene.planar_lights.empty()) doubts.emplace_back("the scene has no light");
  if (scene.blockers.empty() && scene.planar_blockers.empty()) doubts.emplace_back("the scene has no blocker");
  doubt_darkness(scene.lights, doubts);
  doubt_darkness(scene.planar_lights, doubts);
  doubt_duplicates(scene.blockers, doubts);
  doubt_duplicates(scene.planar_blockers, doubts);
  doubt_backs(scene, doubts);
  doubt_dark_receivers(scene, doubts);
  return doubts;
}

}  // namespace gnomon
