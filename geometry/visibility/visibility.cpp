#include "gnomon/visibility.h"

#include <algorithm>
#include <array>

#include "geometry/bodies/body.h"
#include "geometry/bodies/closed_surface.h"
#include "geometry/visibility/prepared_obstacles.h"
#include "geometry/visibility/reach.h"
#include "geometry/visibility/receiver_front.h"
#include "geometry/visibility/rounding_distance.h"
#include "geometry/visibility/visible_fraction.h"
#include "geometry/visibility/visible_part.h"

namespace gnomon {
namespace {

std::vector<std::vector<HidingCondition>> hidden_sets(const Light& light, const Obstacles& obstacles, const Point3& p) {
  const std::vector<Point3> points = light_points(light);
  std::vector<std::vector<HidingCondition>> hidden;
  for (const ConvexBlocker& blocker : obstacles.blockers) {
    if (points.empty() || may_hide(blocker, p, points)) hidden.push_back(hiding_conditions(blocker, exact(p)));
  }
  return hidden;
}

std::span<const Point3> shape_points(const ConvexBlocker& blocker) {
  return std::visit([](const auto& shape) { return shape.points(); }, blocker);
}

std::vector<std::vector<HidingCondition>> hidden_sets(const Light& light, const Obstacles& obstacles,
                                                      const ReceiverPoint& receiver, const ExactPlane& plane) {
  const LimitPoint p{exact(receiver.point), plane.normal};
  const std::vector<Point3> points = light_points(light);
  std::vector<std::vector<HidingCondition>> hidden;
  for (std::uint32_t b = 0; b < obstacles.blockers.size(); ++b) {
    const ConvexBlocker& blocker = obstacles.blockers[b];
    if (std::binary_search(receiver.under.begin(), receiver.under.end(), b)) continue;
    if (!reaches_before(receiver, shape_points(blocker))) continue;
    if (points.empty() || may_hide(blocker, receiver.point, points)) {
      hidden.push_back(hiding_conditions(blocker, p));
    }
  }
  return hidden;
}

bool holds_triangle(const ReceiverPoint& receiver, const ClosedSurface& surface) {
  return std::any_of(surface.triangles.begin(), surface.triangles.end(), [&](const auto& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](std::uint32_t i) { return side_of_front(receiver, surface.vertices[i]) == 0; });
  });
}

/// True if the point rests on one of the surface's triangles, where something lies under it at all.
bool rests_on(const ReceiverPoint& receiver, const ClosedSurface& surface) {
  const auto* facing = std::get_if<FacingNormal>(&receiver.front);
  if (receiver.under.empty() || !facing) return false;
  return std::any_of(surface.triangles.begin(), surface.triangles.end(), [&](const auto& t) {
    const std::array<Point3, 3> corners = {surface.vertices[t[0]], surface.vertices[t[1]], surface.vertices[t[2]]};
    return viewpoint::nearness(corners, receiver.point) != viewpoint::Nearness::apart &&
           viewpoint::faces_alike(corners, facing->normal, false);
  });
}

Visibility visibility(const VisiblePart& part) {
  const VisibleFraction fraction = visible_fraction(part);
  return {part.region, fraction.nearest, fraction.error_bound, fraction_before(part).nearest};
}

}  // namespace

bool is_enclosed(const Obstacles& obstacles, const Point3& p) {
  return std::any_of(obstacles.enclosures.begin(), obstacles.enclosures.end(),
                     [&](const ClosedSurface& surface) { return is_strictly_inside(p, surface); });
}

bool is_enclosed(const Obstacles& obstacles, const ReceiverPoint& receiver) {
  return std::any_of(obstacles.enclosures.begin(), obstacles.enclosures.end(), [&](const ClosedSurface& surface) {
    return is_strictly_inside(receiver.point, surface) && !holds_triangle(receiver, surface) &&
           !rests_on(receiver, surface);
  });
}

VisiblePart exact_visible_part(const Light& light, const Obstacles& obstacles, const Point3& p) {
  std::vector<std::vector<HidingCondition>> hidden = hidden_sets(light, obstacles, p);
  // No condition: everything is hidden.
  if (is_enclosed(obstacles, p)) hidden = {{}};
  return visible_part(light, hidden, exact(p));
}

VisiblePart exact_visible_part(const Light& light, const Obstacles& obstacles, const ReceiverPoint& receiver) {
  const ExactPlane plane = exact_front(receiver);
  std::vector<std::vector<HidingCondition>> hidden = hidden_sets(light, obstacles, receiver, plane);
  if (is_enclosed(obstacles, receiver)) hidden = {{}};
  return visible_part(light, hidden, exact(receiver.point), plane);
}

Visibility exact_visibility(const Light& light, const Obstacles& obstacles, const Point3& p) {
  return visibility(exact_visible_part(light, obstacles, p));
}

Visibility exact_received(const Light& light, const Obstacles& obstacles, const ReceiverPoint& receiver) {
  return visibility(exact_visible_part(light, obstacles, receiver));
}

}  // namespace gnomon
