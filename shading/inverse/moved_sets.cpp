#include "shading/inverse/moved_sets.h"

#include <algorithm>

#include "geometry/bodies/body.h"
#include "shading/inverse/feasible_region.h"
#include "shading/inverse/forward.h"
#include "shading/inverse/goal_sets.h"
#include "shading/inverse/scaled_sets.h"
#include "shading/inverse/shadow_sets.h"

namespace gnomon::inverse {
namespace {

ExactVector difference(const Point3& a, const Point3& b) {
  return exact(a) - exact(b);
}

/// The largest value that a plane's normal takes at points.
Rational most(const ExactVector& normal, std::span<const Point3> points) {
  Rational largest = dot(normal, exact(points[0]));
  for (const Point3& p : points) largest = std::max(largest, Rational(dot(normal, exact(p))));
  return largest;
}

/// The shifts by which all points stay within every plane of a set.
ConvexSet shifts_within(DesignSpace& space, const ConvexSet& set, std::span<const Point3> points, Grazing grazing) {
  ConvexSet result;
  for (const Wall& wall : set.walls) {
    const Whole& plane = space.cells.plane(wall.plane);
    const ExactVector normal = normal_of(plane);
    const Whole shifted = whole_plane(normal, Rational(Rational(plane[3]) + most(normal, points)));
    result.walls.push_back(
        {space.add(shifted, space.names[wall.plane]), grazing == Grazing::counts_not || wall.is_closed});
  }
  return result;
}

/// The occlusion of a subject as points and directions: the blocker, and what leads from the subject to it.
std::vector<Whole> shadow_minus_light(const DesignSubject& subject, const ConvexBlocker& blocker,
                                      std::span<const Point3> light) {
  std::vector<Whole> generators;
  for (const Point3& b : points_of(blocker)) {
    for (const Point3& l : light) generators.push_back(whole_point(difference(b, l)));
    for (const Point3& q : subject.points) {
      if (q != b) generators.push_back(whole_direction(difference(b, q)));
    }
  }
  return generators;
}

/// The sets of one moved light behind one blocker.
struct MovedSets {
  std::optional<ConvexSet> dark;
  std::optional<ConvexSet> touched;
};

MovedSets moved_light_sets(DesignSpace& space, const DesignSubject& subject, const ConvexBlocker& blocker,
                           std::span<const Point3> light, const GoalPart& names) {
  const Grazing grazing = light.size() > 1 || subject.points.size() > 1 ? Grazing::counts_not : Grazing::hides;
  const SubjectShadow shadow = subject_shadow(space, subject, blocker, names);
  MovedSets sets;
  if (shadow.umbra) sets.dark = shifts_within(space, *shadow.umbra, light, grazing);
  if (!shadow.occlusion) return sets;
  // Inside a solid all is dark.
  if (shadow.occlusion->walls.empty()) {
    sets.touched = ConvexSet{};
  } else if (!shadow.occlusion->flat) {
    sets.touched = hull_set(space, shadow_minus_light(subject, blocker, light), names, grazing == Grazing::hides);
  } else if (grazing == Grazing::hides) {
    sets.touched = flat_hull_set(space, shadow_minus_light(subject, blocker, light), names);
  }
  return sets;
}

/// What a point sees behind all blockers is a union of cells; the light must not reach into one of them.
void add_joint_darkness(DesignSpace& space, std::span<const Point3> light, std::vector<ConvexSet> dark,
                        std::uint32_t goal, GoalSets& sets) {
  GoalSets outside;
  outside.none = std::move(dark);
  const std::vector<Cell> seen = feasible_cells(space, DesignDomain{}, {outside}, {}).cells;
  for (const Cell& cell : seen) {
    std::vector<Whole> generators;
    for (const Corner& corner : cell.corners) {
      const Whole whole = space.cells.corner(corner.id);
      for (const Point3& l : light) generators.push_back(whole_point(coordinates(whole) - exact(l)));
    }
    if (auto set = hull_set(space, generators, {goal, 0}, false)) sets.none.push_back(std::move(*set));
  }
}

/// The light stands before the subject whole, and a one-sided one shows it its front.
void add_fronts(DesignSpace& space, const Design& design, std::uint32_t goal, const DesignSubject& subject,
                std::span<const Point3> light, GoalSets& sets) {
  DesignWall name;
  name.kind = DesignWall::Kind::front;
  name.goal = goal;
  if (subject.front) {
    const Whole plane = front_plane(subject);
    const ExactVector normal = normal_of(plane);
    const Whole moved = whole_plane(normal, Rational(Rational(plane[3]) + most(normal, light)));
    sets.within.push_back({space.add(moved, name), light.size() > 1});
  }
  const auto* area = std::get_if<AreaLight>(&design.light);
  if (!area) return;
  const ExactPlane plane = plane_of(*area);
  if (area->two_sided) {
    // In its own plane it shows its edge alone.
    if (subject.points.size() > 1) return;
    const Rational height = plane.height(exact(subject.points[0]));
    sets.none.push_back(whole_plane_set(space, plane.normal, Rational(-height), name));
    return;
  }
  for (const Point3& q : subject.points) {
    // n (q - l - t) > 0.
    sets.within.push_back(
        {space.add(whole_plane(plane.normal, Rational(-plane.height(exact(q)))), name), subject.points.size() > 1});
  }
}

void add_translations(DesignSpace& space, const Design& design, std::uint32_t number, const DesignSubject& subject,
                      const DesignObstacles& obstacles, GoalSets& sets) {
  const DesignGoal& goal = design.goals[number];
  const std::vector<Point3> light = light_points(design.light);
  add_fronts(space, design, number, subject, light, sets);
  std::vector<ConvexSet> dark, touched, cones;
  const auto parts = parts_that_count(goal, obstacles);
  for (const std::uint32_t part : parts) {
    const ConvexBlocker& blocker = obstacles.obstacles.blockers[part];
    MovedSets moved = moved_light_sets(space, subject, blocker, light, {number, part});
    if (moved.dark) dark.push_back(std::move(*moved.dark));
    if (moved.touched) touched.push_back(std::move(*moved.touched));
    if (parts.size() > 1 && subject.points.size() == 1) {
      SubjectShadow cone = subject_shadow(space, subject, blocker, {number, part});
      if (cone.umbra) cones.push_back(std::move(*cone.umbra));
    }
  }
  const bool is_dark = goal.want == Want::dark || goal.want == Want::not_seen_from;
  if (goal.want == Want::lit) {
    std::ranges::move(touched, std::back_inserter(sets.none));
  } else if (is_dark && cones.size() > 1 && light.size() > 1) {
    add_joint_darkness(space, light, std::move(cones), number, sets);
  } else if (is_dark) {
    if (subject.points.size() > 1) sets.overlapping.push_back(touched);
    sets.any.push_back(std::move(dark));
  } else if (subject.points.size() > 1 || (goal.want == Want::penumbra && parts.size() > 1)) {
    throw DesignError("goal \"" + goal.name +
                      "\": a light with size in partial shadow is asked of a point, and penumbra of one blocker");
  } else {
    // Inside, not on the boundary: there all is lit.
    for (ConvexSet& set : touched) {
      for (Wall& wall : set.walls) wall.is_closed = false;
    }
    sets.any.push_back(std::move(touched));
    if (goal.want == Want::penumbra) std::ranges::move(dark, std::back_inserter(sets.none));
  }
}

/// The shifts by which a blocker meets the segment, or ray, from a point to a light's corner.
std::optional<ConvexSet> meeting_shifts(DesignSpace& space, const Point3& q, const Whole& light,
                                        const ConvexBlocker& blocker, const GoalPart& names) {
  std::vector<Whole> generators;
  for (const Point3& b : points_of(blocker)) {
    generators.push_back(whole_point(difference(q, b)));
    if (light[3] != 0) generators.push_back(whole_point(coordinates(light) - exact(b)));
  }
  if (light[3] == 0) generators.push_back(light);
  if (auto set = hull_set(space, generators, names, true)) return set;
  return flat_hull_set(space, std::move(generators), names);
}

std::vector<Whole> light_corners(const Light& light) {
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
    return {whole_direction(Rational(-1) * exact(sun->direction))};
  }
  std::vector<Whole> corners;
  for (const Point3& l : light_points(light)) corners.push_back(whole_point(l));
  return corners;
}

/// Shifts of a part of the blocker that darken all of the subject.
std::optional<ConvexSet> darkening_shifts(DesignSpace& space, const DesignSubject& subject, const Light& light,
                                          const ConvexBlocker& part, const GoalPart& names) {
  ConvexSet all;
  for (const Point3& q : subject.points) {
    for (const Whole& corner : light_corners(light)) {
      const auto set = meeting_shifts(space, q, corner, part, names);
      if (!set) return std::nullopt;
      std::ranges::copy(set->walls, std::back_inserter(all.walls));
    }
  }
  return all;
}

/// Shifts of a part of the blocker that hide something.
std::optional<ConvexSet> touching_shifts(DesignSpace& space, const DesignSubject& subject, const Light& light,
                                         const ConvexBlocker& part, const GoalPart& names) {
  const std::vector<Whole> corners = light_corners(light);
  std::vector<Whole> generators;
  for (const Point3& b : points_of(part)) {
    for (const Point3& q : subject.points) generators.push_back(whole_point(difference(q, b)));
    for (const Whole& corner : corners) {
      generators.push_back(corner[3] == 0 ? corner : whole_point(coordinates(corner) - exact(b)));
    }
  }
  const bool is_closed = subject.points.size() == 1 && corners.size() == 1;
  if (auto set = hull_set(space, generators, names, is_closed)) return set;
  return is_closed ? flat_hull_set(space, std::move(generators), names) : std::nullopt;
}

void add_blocker_shifts(DesignSpace& space, const Design& design, std::uint32_t number, const DesignSubject& subject,
                        const DesignObstacles& obstacles, GoalSets& sets) {
  const DesignGoal& goal = design.goals[number];
  const auto fixed = forward_region(goal.light, subject, obstacles_that_count(goal, obstacles, design.blocker));
  if (!fixed) throw DesignError("goal \"" + goal.name + "\": its receiver cannot be divided");
  if (fixed == Region::unlit) return sets.any.emplace_back(), void();
  const bool is_lit = goal.want == Want::lit, is_dark = goal.want == Want::dark;
  if (!is_lit && !is_dark) {
    throw DesignError("goal \"" + goal.name + "\": a moved blocker makes subjects lit or dark, nothing else yet");
  }
  if (is_dark && fixed == Region::umbra) return;
  if (is_lit && fixed != Region::lit) return sets.any.emplace_back(), void();
  std::vector<ConvexSet> dark, touched;
  for (const std::uint32_t part : parts_that_count(goal, obstacles)) {
    if (obstacles.elements[part] != design.blocker) continue;
    const ConvexBlocker& blocker = obstacles.obstacles.blockers[part];
    if (is_dark) {
      if (auto set = darkening_shifts(space, subject, goal.light, blocker, {number, part}))
        dark.push_back(std::move(*set));
    }
    if (auto set = touching_shifts(space, subject, goal.light, blocker, {number, part}))
      touched.push_back(std::move(*set));
  }
  if (is_lit) {
    std::ranges::move(touched, std::back_inserter(sets.none));
    return;
  }
  sets.any.push_back(std::move(dark));
  // A part of the subject, or of the light, that something else hides may be all that the blocker leaves.
  if (fixed == Region::penumbra) touched.emplace_back();
  const bool has_size = subject.points.size() > 1 || light_corners(goal.light).size() > 1;
  if (has_size) sets.overlapping.push_back(std::move(touched));
}

}  // namespace

void add_moved_sets(DesignSpace& space, const Design& design, std::uint32_t goal, const DesignSubject& subject,
                    const DesignObstacles& obstacles, GoalSets& sets) {
  switch (design.variable) {
    case FreeVariable::translation:
      return add_translations(space, design, goal, subject, obstacles, sets);
    case FreeVariable::blocker:
      return add_blocker_shifts(space, design, goal, subject, obstacles, sets);
    case FreeVariable::scale:
      return add_scales(space, design, goal, subject, obstacles, sets);
    default:
      break;
  }
}

}  // namespace gnomon::inverse
