#include "shading/inverse/forward.h"

#include <algorithm>

#include "gnomon/receiver_mesh.h"
#include "shading/inverse/goal_sets.h"

namespace gnomon::inverse {
namespace {

/// For a point light the polygon takes the light's part: what the light sees of it is what it lights.
Region region_before(const PointLight& light, const DesignSubject& subject, const Obstacles& obstacles) {
  if (subject.front && value(front_plane(subject), whole_point(light.position)) >= 0) return Region::unlit;
  return exact_visibility(as_light(subject), obstacles, light.position).region;
}

std::optional<Region> divided_region(const Light& light, const DesignSubject& subject, const Obstacles& obstacles) {
  const ConvexPolygon polygon = ConvexPolygon::from_points(subject.points);
  if (!division_refusal(light, obstacles.enclosures).empty() || !range_refusal(light).empty() ||
      !range_refusal(subject.points).empty()) {
    return std::nullopt;
  }
  for (const ConvexBlocker& blocker : obstacles.blockers) {
    if (!range_refusal(points_of(blocker)).empty()) return std::nullopt;
  }
  const auto meshes = receiver_division(light, obstacles.blockers, {&polygon, 1}, obstacles.enclosures);
  std::optional<Region> all;
  const auto areas = meshes.front().areas();
  for (std::size_t k = 0; k < areas.size(); ++k) {
    if (areas[k].nearest == 0) continue;
    all = all ? Region::penumbra : static_cast<Region>(k);
  }
  return all;
}

Point3 sum(const Point3& a, const Point3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

std::vector<Point3> moved_points(std::span<const Point3> points, const Point3& by) {
  std::vector<Point3> result;
  for (const Point3& p : points) result.push_back(sum(p, by));
  return result;
}

Light moved_light(const Light& light, const Point3& by) {
  if (const auto* point = std::get_if<PointLight>(&light)) return PointLight{sum(point->position, by)};
  if (const auto* line = std::get_if<LinearLight>(&light)) return LinearLight{sum(line->start, by), sum(line->end, by)};
  const auto& area = std::get<AreaLight>(light);
  return AreaLight{ConvexPolygon::from_points(moved_points(area.polygon.points(), by)), area.two_sided};
}

Light scaled_light(const Light& light, const Point3& centre, double s) {
  const auto scaled = [&](const Point3& p) {
    return Point3{centre.x + s * (p.x - centre.x), centre.y + s * (p.y - centre.y), centre.z + s * (p.z - centre.z)};
  };
  if (const auto* line = std::get_if<LinearLight>(&light)) return LinearLight{scaled(line->start), scaled(line->end)};
  const auto& area = std::get<AreaLight>(light);
  std::vector<Point3> points;
  for (const Point3& p : area.polygon.points()) points.push_back(scaled(p));
  return AreaLight{ConvexPolygon::from_points(std::move(points)), area.two_sided};
}

}  // namespace

std::optional<Region> forward_region(const Light& light, const DesignSubject& subject, const Obstacles& obstacles) {
  if (subject.points.size() == 1) {
    const Point3& q = subject.points[0];
    return subject.front ? exact_received(light, obstacles, {q, *subject.front}).region
                         : exact_visibility(light, obstacles, q).region;
  }
  if (const auto* point = std::get_if<PointLight>(&light)) return region_before(*point, subject, obstacles);
  return divided_region(light, subject, obstacles);
}

Obstacles obstacles_that_count(const DesignGoal& goal, const DesignObstacles& obstacles, const std::string& left_out) {
  Obstacles counting;
  for (const std::uint32_t part : parts_that_count(goal, obstacles)) {
    if (left_out.empty() || obstacles.elements[part] != left_out) {
      counting.blockers.push_back(obstacles.obstacles.blockers[part]);
    }
  }
  if (goal.by.empty()) counting.enclosures = obstacles.obstacles.enclosures;
  return counting;
}

ConvexBlocker moved(const ConvexBlocker& blocker, const Point3& by) {
  if (const auto* polygon = std::get_if<ConvexPolygon>(&blocker)) {
    return ConvexPolygon::from_points(moved_points(polygon->points(), by));
  }
  return ConvexSolid::hull_of(moved_points(std::get<ConvexSolid>(blocker).points(), by));
}

Light placed_light(const Design& design, const DesignGoal& goal, const Point3& position) {
  switch (design.variable) {
    case FreeVariable::position:
      return PointLight{position};
    case FreeVariable::direction:
      return DirectionalLight{{-position.x, -position.y, -position.z}};
    case FreeVariable::translation:
      return moved_light(design.light, position);
    case FreeVariable::scale:
      return scaled_light(design.light, design.centre, position.x);
    case FreeVariable::blocker:
      break;
  }
  return goal.light;
}

Obstacles placed_obstacles(const Design& design, const DesignGoal& goal, const DesignObstacles& obstacles,
                           const Point3& position) {
  if (design.variable != FreeVariable::blocker) return obstacles_that_count(goal, obstacles);
  Obstacles placed = obstacles_that_count(goal, obstacles, design.blocker);
  for (const std::uint32_t part : parts_that_count(goal, obstacles)) {
    if (obstacles.elements[part] == design.blocker) {
      placed.blockers.push_back(moved(obstacles.obstacles.blockers[part], position));
    }
  }
  return placed;
}

}  // namespace gnomon::inverse
