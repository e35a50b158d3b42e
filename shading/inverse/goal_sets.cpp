#include "shading/inverse/goal_sets.h"

#include <algorithm>

#include "shading/inverse/forward.h"
#include "shading/inverse/highlight.h"
#include "shading/inverse/moved_sets.h"
#include "shading/inverse/shadow_sets.h"

namespace gnomon::inverse {
namespace {

/// A list of no alternatives: no position will do.
void forbid(GoalSets& sets) {
  sets.any.emplace_back();
}

void add_front(DesignSpace& space, const DesignSubject& subject, std::uint32_t goal, GoalSets& sets) {
  if (!subject.front) return;
  DesignWall name;
  name.kind = DesignWall::Kind::front;
  name.goal = goal;
  sets.within.push_back({space.add(front_plane(subject), name), false});
}

/// Goals of shadow for a light without size, at a position or in a direction.
void add_shadow_sets(DesignSpace& space, const DesignGoal& goal, const DesignSubject& subject, std::uint32_t number,
                     const DesignObstacles& obstacles, GoalSets& sets) {
  const bool is_lit = goal.want != Want::dark && goal.want != Want::shadow && goal.want != Want::not_seen_from;
  std::vector<ConvexSet> dark, touched;
  for (const std::uint32_t part : parts_that_count(goal, obstacles)) {
    SubjectShadow shadow = subject_shadow(space, subject, obstacles.obstacles.blockers[part], {number, part});
    if (shadow.umbra) dark.push_back(std::move(*shadow.umbra));
    if (shadow.occlusion) touched.push_back(std::move(*shadow.occlusion));
  }
  if (is_lit) {
    std::ranges::move(touched, std::back_inserter(sets.none));
    return;
  }
  sets.any.push_back(std::move(dark));
  if (subject.points.size() > 1) sets.overlapping.push_back(std::move(touched));
}

/// The plane through the subject and two points, and what of it lies beyond them.
void add_edge(DesignSpace& space, const DesignSubject& subject, const Point3& from, const Point3& to,
              const ConvexBlocker& blocker, const DesignWall& name, GoalSets& sets) {
  const ExactVector q = exact(subject.points[0]), a = exact(from), b = exact(to);
  const ExactPlane plane = plane_through(q, a, b);
  const auto other_side = [&](int sign) {
    return [&plane, sign](const Point3& p) { return plane.height(exact(p)).sign() == sign; };
  };
  const auto points = points_of(blocker);
  // An edge inside of what the blocker covers, seen from here, bounds no shadow.
  if (is_zero(plane.normal) ||
      (std::ranges::any_of(points, other_side(1)) && std::ranges::any_of(points, other_side(-1)))) {
    return forbid(sets);
  }
  sets.on.push_back(space.add(whole_plane(plane.normal, plane.offset), name));
  const std::vector<Whole> generators = {whole_point(a),
                                         whole_point(b),
                                         whole_direction(a - q),
                                         whole_direction(b - q),
                                         whole_direction(plane.normal),
                                         whole_direction(Rational(-1) * plane.normal)};
  const auto beyond = hull_set(space, generators, {name.goal, name.part}, true);
  if (beyond) std::ranges::copy(beyond->walls, std::back_inserter(sets.within));
}

/// The ray from a point along a vector, without its start.
void add_ray(DesignSpace& space, const ExactVector& q, const ExactVector& along, const ExactVector& start,
             const DesignWall& name, GoalSets& sets) {
  ExactVector axis;
  axis[along.x == 0 ? 0 : along.y == 0 ? 1 : 2] = 1;
  if (is_zero(cross(along, axis))) axis = {1, 0, 0};
  const ExactVector across = cross(along, axis), other = cross(along, across);
  sets.on.push_back(space.add(whole_plane(across, Rational(-dot(across, q))), name));
  sets.on.push_back(space.add(whole_plane(other, Rational(-dot(other, q))), name));
  sets.within.push_back({space.add(whole_plane(Rational(-1) * along, dot(along, start)), name), false});
}

/// The ray from a blocker's vertex away from the subject.
void add_nail(DesignSpace& space, const DesignSubject& subject, const Point3& vertex, const DesignWall& name,
              GoalSets& sets) {
  const ExactVector q = exact(subject.points[0]), b = exact(vertex), along = b - q;
  if (is_zero(along)) return forbid(sets);
  add_ray(space, q, along, b, name, sets);
}

/// The ray on which a light makes the subject brightest, or is mirrored there.
void add_peak(DesignSpace& space, const DesignGoal& goal, const DesignSubject& subject, std::uint32_t number,
              GoalSets& sets) {
  const ExactVector q = exact(subject.points[0]), normal = exact(std::get<FacingNormal>(*subject.front).normal);
  const auto along = goal.want == Want::highlight ? mirror_direction(normal, exact(goal.eye) - q) : normal;
  if (!along) return forbid(sets);
  DesignWall name;
  name.kind = DesignWall::Kind::front;
  name.goal = number;
  add_ray(space, q, *along, q, name, sets);
}

/// Edges and nails name elements of a blocker of one part.
void add_boundary(DesignSpace& space, const DesignGoal& goal, std::uint32_t number, const DesignObstacles& obstacles,
                  GoalSets& sets) {
  const std::vector<std::uint32_t> parts = parts_that_count(goal, obstacles);
  if (parts.size() != 1) throw DesignError("goal \"" + goal.name + "\": its blocker is not one convex part");
  const ConvexBlocker& blocker = obstacles.obstacles.blockers[parts[0]];
  DesignWall name;
  name.kind = DesignWall::Kind::shadow;
  name.goal = number;
  name.part = parts[0];
  if (goal.want == Want::nail) {
    name.vertex = goal.element;
    return add_nail(space, goal.subjects[0], points_of(blocker)[goal.element], name, sets);
  }
  name.subject = 0;
  name.edge = goal.element;
  const auto points = points_of(blocker);
  std::uint32_t from = goal.element, to = (goal.element + 1) % static_cast<std::uint32_t>(points.size());
  if (const auto* solid = std::get_if<ConvexSolid>(&blocker)) {
    from = solid->edges()[goal.element].from;
    to = solid->edges()[goal.element].to;
  }
  add_edge(space, goal.subjects[0], points[from], points[to], blocker, name, sets);
}

}  // namespace

std::vector<std::uint32_t> parts_that_count(const DesignGoal& goal, const DesignObstacles& obstacles) {
  std::vector<std::uint32_t> parts;
  for (std::uint32_t p = 0; p < obstacles.parts.size(); ++p) {
    if (goal.by.empty() || obstacles.elements[p] == goal.by || obstacles.parts[p] == goal.by) parts.push_back(p);
  }
  return parts;
}

std::span<const Point3> points_of(const ConvexBlocker& blocker) {
  return std::visit([](const auto& shape) { return shape.points(); }, blocker);
}

Light as_light(const DesignSubject& subject) {
  if (subject.points.size() == 1) return PointLight{subject.points[0]};
  return AreaLight{ConvexPolygon::from_points(subject.points), true};
}

ExactPlane plane_of(const AreaLight& light) {
  const auto points = light.polygon.points();
  const auto corners = light.polygon.corners();
  return plane_through(exact(points[corners[0]]), exact(points[corners[1]]), exact(points[corners[2]]));
}

Whole front_plane(const DesignSubject& subject) {
  if (const auto* facet = std::get_if<FacetFront>(&*subject.front)) {
    const ExactPlane plane =
        plane_through(exact(facet->corners[0]), exact(facet->corners[1]), exact(facet->corners[2]));
    return whole_plane(Rational(-1) * plane.normal, Rational(-plane.offset));
  }
  const ExactVector normal = exact(std::get<FacingNormal>(*subject.front).normal);
  return whole_plane(Rational(-1) * normal, dot(normal, exact(subject.points[0])));
}

GoalSets goal_sets(DesignSpace& space, const Design& design, std::uint32_t number, const DesignObstacles& obstacles) {
  const DesignGoal& goal = design.goals[number];
  GoalSets sets;
  if (goal.want == Want::edge || goal.want == Want::nail) {
    add_boundary(space, goal, number, obstacles, sets);
    return sets;
  }
  for (const DesignSubject& subject : goal.subjects) {
    if (design.variable != FreeVariable::position && design.variable != FreeVariable::direction) {
      add_moved_sets(space, design, number, subject, obstacles, sets);
      continue;
    }
    add_front(space, subject, number, sets);
    if (goal.want == Want::no_reflection) {
      sets.none.push_back(mirror_set(space, subject, goal.eye, number));
    } else {
      if (goal.want == Want::diffuse_peak || goal.want == Want::highlight) add_peak(space, goal, subject, number, sets);
      add_shadow_sets(space, goal, subject, number, obstacles, sets);
    }
  }
  return sets;
}

}  // namespace gnomon::inverse
