#include "geometry/visibility/visibility.h"

#include <algorithm>

#include "geometry/visibility/exact_visible_part.h"
#include "geometry/visibility/reach.h"
#include "geometry/visibility/visible_fraction.h"

namespace gnomon {
namespace {

/// The light's vertices; none for a direction.
std::vector<Point3> vertices(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light)) return {point->position};
  if (const auto* linear = std::get_if<LinearLight>(&light)) return {linear->start, linear->end};
  const auto* area = std::get_if<AreaLight>(&light);
  if (!area) return {};
  return {area->polygon.points().begin(), area->polygon.points().end()};
}

std::vector<std::vector<HidingCondition>> hidden_sets(const Light& light, const Obstacles& obstacles, const Point3& p) {
  const std::vector<Point3> points = vertices(light);
  std::vector<std::vector<HidingCondition>> hidden;
  for (const ConvexBlocker& blocker : obstacles.blockers) {
    if (points.empty() || may_hide(blocker, p, points)) hidden.push_back(hiding_conditions(blocker, exact(p)));
  }
  return hidden;
}

}  // namespace

VisiblePart exact_visible_part(const Light& light, const Obstacles& obstacles, const Point3& p) {
  std::vector<std::vector<HidingCondition>> hidden = hidden_sets(light, obstacles, p);
  const bool enclosed = std::any_of(obstacles.enclosures.begin(), obstacles.enclosures.end(),
                                    [&](const ClosedSurface& surface) { return is_strictly_inside(p, surface); });
  // No condition: everything is hidden.
  if (enclosed) hidden = {{}};
  return visible_part(light, hidden, exact(p));
}

Visibility exact_visibility(const Light& light, const Obstacles& obstacles, const Point3& p) {
  const VisiblePart part = exact_visible_part(light, obstacles, p);
  const VisibleFraction fraction = visible_fraction(part);
  return {part.region, fraction.nearest, fraction.error_bound};
}

}  // namespace gnomon
