#include "geometry/scene/lights_in_solids.h"

#include <algorithm>
#include <array>

#include "geometry/bodies/body.h"
#include "geometry/bodies/closed_surface.h"
#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/orientation.h"
#include "geometry/numbers/vector3.h"
#include "geometry/scene/json_text.h"
#include "geometry/scene/scene_points.h"

namespace gnomon {
namespace {

/// The largest side that a point is on of the planes of a solid's facets: negative inside, 0 on the surface.
int farthest_side(const Point3& p, const ConvexSolid& solid) {
  int most = -1;
  for (const ConvexSolid::Facet& facet : solid.facets()) {
    const auto corner = [&](std::size_t k) { return solid.points()[facet.loop[k]]; };
    most = std::max(most, exact_orientation(corner(0), corner(1), corner(2), p));
  }
  return most;
}

/// In the closed box around the points.
bool is_in_box_of(const Point3& p, std::span<const Point3> points) {
  return std::ranges::all_of(std::array{&Point3::x, &Point3::y, &Point3::z}, [&](double Point3::*c) {
    return std::ranges::any_of(points, [&](const Point3& q) { return q.*c <= p.*c; }) &&
           std::ranges::any_of(points, [&](const Point3& q) { return q.*c >= p.*c; });
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
    if (solid && std::ranges::any_of(points, [&](const Point3& p) { return farthest_side(p, *solid) < 0; }))
      return "a solid";
  }
  return "";
}

/// True of a one-sided light on the surface of a solid that is wholly before it.
bool shines_into(const SceneLight& light, const ConvexSolid& solid) {
  const auto* area = std::get_if<AreaLight>(&light.shape);
  if (!area || area->two_sided || !area->polygon.is_flat()) return false;
  const auto points = area->polygon.points();
  const auto corner = [&](std::size_t k) { return points[area->polygon.corners()[k]]; };
  const auto is_before = [&](const Point3& p) { return exact_orientation(corner(0), corner(1), corner(2), p) >= 0; };
  return std::ranges::all_of(solid.points(), is_before) &&
         std::ranges::all_of(points, [&](const Point3& p) { return farthest_side(p, solid) <= 0; });
}

bool shines_into(std::span<const SceneLight> parts, const SceneBlocker& blocker) {
  if (std::holds_alternative<ConvexPolygon>(blocker.shape)) return false;
  const auto corners = blocker_points(blocker.shape);
  const auto is_near = [&](const Point3& p) { return is_in_box_of(p, corners); };
  if (!std::ranges::all_of(light_points(parts[0].shape), is_near)) return false;
  const std::vector<ConvexPart> solids = convex_parts(blocker);
  return std::ranges::any_of(parts, [&](const SceneLight& light) {
    return std::ranges::any_of(solids, [&](const ConvexPart& part) {
      const auto* solid = std::get_if<ConvexSolid>(&part.shape);
      return solid && shines_into(light, *solid);
    });
  });
}

/// By how far a lamp on a flat blocker is off its plane, if that is no more than what was rounded; 0 if it is not.
double rounded_off(const ConvexPolygon& lamp, const ConvexPolygon& blocker) {
  const auto points = blocker.points();
  const auto corner = [&](std::size_t k) { return points[blocker.corners()[k]]; };
  const Vector3<double> normal = cross(step(corner(0), corner(1)), step(corner(0), corner(2)));
  Point3 middle{0, 0, 0};
  const auto n = static_cast<double>(lamp.points().size());
  for (const Point3& p : lamp.points()) middle = {middle.x + p.x / n, middle.y + p.y / n, middle.z + p.z / n};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vector3<double> along = step(points[k], points[(k + 1) % points.size()]);
    if (dot(cross(along, step(points[k], middle)), normal) < 0) return 0;
  }
  std::vector<Point3> all(points.begin(), points.end());
  all.insert(all.end(), lamp.points().begin(), lamp.points().end());
  const PolygonPlane plane = polygon_plane(all).value();
  return plane.flatness == Flatness::rounded ? plane.deviation : 0;
}

void doubt_rounded_lamp(const SceneLight& part, const SceneBlocker& blocker, const std::string& unit,
                        std::vector<std::string>& doubts) {
  const auto* lamp = std::get_if<AreaLight>(&part.shape);
  const auto* wall = std::get_if<ConvexPolygon>(&blocker.shape);
  const double off = lamp && wall ? rounded_off(lamp->polygon, *wall) : 0;
  if (off == 0) return;
  doubts.push_back(element_title("lights", part.element) + ": it lies on " + element_title("blockers", blocker.name) +
                   ", but its vertices were rounded off that plane, by up to " + few_digits(off) + " " + unit +
                   ": what came behind the blocker is hidden, and before it all is seen; move it a little to the side "
                   "that it is to light");
}

void doubt_light(std::span<const SceneLight> parts, const SceneBlocker& blocker, std::vector<std::string>& doubts) {
  std::vector<Point3> points;
  for (const SceneLight& part : parts) {
    for (const Point3& p : light_points(part.shape)) points.push_back(p);
  }
  const std::string light = element_title("lights", parts[0].element);
  const std::string title = element_title("blockers", blocker.name);
  // A room as a closed mesh is a solid to the program, and dark.
  if (const std::string what = filling(blocker, points); !what.empty()) {
    doubts.push_back(light + ": it reaches into " + title + ", " + what +
                     ": all inside is in the umbra, and what of the light is there shines nowhere; leave out a facet, "
                     "or write walls as polygons, for a room with air in it");
  } else if (shines_into(parts, blocker)) {
    doubts.push_back(light + ": it lies on " + title +
                     " and shines into it; a polygon light shines to the side from which its vertices run "
                     "counterclockwise");
  }
}

}  // namespace

std::vector<std::span<const SceneLight>> light_elements(std::span<const SceneLight> lights) {
  std::vector<std::span<const SceneLight>> elements;
  for (std::size_t first = 0, last = 0; first < lights.size(); first = last) {
    while (last < lights.size() && lights[last].element == lights[first].element) ++last;
    elements.push_back(lights.subspan(first, last - first));
  }
  return elements;
}

void doubt_lights_in_solids(const SpaceScene& scene, std::vector<std::string>& doubts) {
  for (const auto parts : light_elements(scene.lights)) {
    if (std::holds_alternative<DirectionalLight>(parts[0].shape)) continue;
    for (const SceneBlocker& blocker : scene.blockers) {
      doubt_light(parts, blocker, doubts);
      for (const SceneLight& part : parts) doubt_rounded_lamp(part, blocker, scene.length_unit, doubts);
    }
  }
}

}  // namespace gnomon
