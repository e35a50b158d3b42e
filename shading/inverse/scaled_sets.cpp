#include "shading/inverse/scaled_sets.h"

#include <algorithm>

#include "geometry/bodies/body.h"
#include "shading/inverse/goal_sets.h"
#include "shading/inverse/linear_program.h"
#include "shading/inverse/shadow_sets.h"

namespace gnomon::inverse {
namespace {

/// A light's corners as they lead away from the centre of scaling.
struct ScaledLight {
  ExactVector centre;
  std::vector<ExactVector> arms;

  explicit ScaledLight(const Design& design) : centre(exact(design.centre)) {
    for (const Point3& l : light_points(design.light)) arms.push_back(exact(l) - centre);
  }
};

/// The plane a s + b = 0 of scales at which a corner crosses a plane; nothing if the corner's arm runs along it and it
/// stays within.
Whole scale_plane(const ExactPlane& plane, const ScaledLight& light, const ExactVector& arm) {
  return whole_plane({dot(plane.normal, arm), 0, 0}, plane.height(light.centre));
}

ExactPlane exact_plane(const Whole& plane) {
  return {normal_of(plane), Rational(plane[3])};
}

/// Scales at which every corner stays within a set.
ConvexSet scales_within(DesignSpace& space, const ConvexSet& set, const ScaledLight& light) {
  ConvexSet result;
  for (const Wall& wall : set.walls) {
    for (const ExactVector& arm : light.arms) {
      const Whole plane = scale_plane(exact_plane(space.cells.plane(wall.plane)), light, arm);
      result.walls.push_back({space.add(plane, DesignWall(space.names[wall.plane])), true});
    }
  }
  return result;
}

/// Weights λ >= 0 of arms, and a slack for each wall, with centre + Σ λ arm within a set: Σ λ is a scale.
StandardProgram scales_program(const DesignSpace& space, const ConvexSet& set, const ScaledLight& light) {
  StandardProgram program;
  const std::size_t rows = set.walls.size();
  program.columns.assign(light.arms.size(), std::vector<Rational>(rows, 0));
  program.cost.assign(light.arms.size(), 0);
  for (std::size_t i = 0; i < rows; ++i) {
    const ExactPlane plane = exact_plane(space.cells.plane(set.walls[i].plane));
    program.right.push_back(-plane.height(light.centre));
    for (std::size_t j = 0; j < light.arms.size(); ++j) program.columns[j][i] = dot(plane.normal, light.arms[j]);
    program.columns.emplace_back(rows, 0);
    program.columns.back()[i] = 1;
    program.cost.push_back(0);
  }
  return program;
}

/// The scale that is least, or with `sign` -1 largest.
ProgramSolution extreme_scale(StandardProgram program, const ScaledLight& light, int sign) {
  for (std::size_t j = 0; j < light.arms.size(); ++j) program.cost[j] = sign;
  return solved_program(program);
}

/// True if at some scale the light has a point inside of the set, not only on its boundary: then a slack that all walls
/// have in common, of at most 1, is more than 0.
bool reaches_inside(StandardProgram program) {
  for (std::vector<Rational>& column : program.columns) column.emplace_back(0);
  std::vector<Rational> common(program.right.size(), 1), rest(program.right.size(), 0);
  common.emplace_back(1);
  rest.emplace_back(1);
  program.columns.push_back(std::move(common));
  program.columns.push_back(std::move(rest));
  program.right.emplace_back(1);
  program.cost.emplace_back(-1);
  program.cost.emplace_back(0);
  const ProgramSolution solution = solved_program(program);
  return solution.kind == ProgramSolution::Kind::optimal && solution.y[program.columns.size() - 2] > 0;
}

Rational sum_of_arms(const ProgramSolution& solution, std::size_t count) {
  Rational sum = 0;
  for (std::size_t j = 0; j < count; ++j) sum += solution.y[j];
  return sum;
}

/// The open interval of scales at which the light reaches into a set; nothing if there is none.
std::optional<ConvexSet> scales_into(DesignSpace& space, const ConvexSet& set, const ScaledLight& light,
                                     const GoalPart& names) {
  if (set.flat) return std::nullopt;
  if (set.walls.empty()) return ConvexSet{};
  const StandardProgram program = scales_program(space, set, light);
  if (!reaches_inside(program)) return std::nullopt;
  const ProgramSolution least = extreme_scale(program, light, 1), most = extreme_scale(program, light, -1);
  DesignWall name;
  name.kind = DesignWall::Kind::sum;
  name.goal = names.goal;
  name.part = names.part;
  const Rational from = sum_of_arms(least, light.arms.size());
  ConvexSet result;
  result.walls.push_back({space.add(whole_plane({-1, 0, 0}, from), name), false});
  if (most.kind == ProgramSolution::Kind::unbounded) return result;
  const Rational to = sum_of_arms(most, light.arms.size());
  if (to == from) return std::nullopt;
  result.walls.push_back({space.add(whole_plane({1, 0, 0}, Rational(-to)), name), false});
  return result;
}

/// The light stands before the subject whole, and a one-sided one shows it its front.
void add_fronts_of_scales(DesignSpace& space, const Design& design, std::uint32_t goal, const DesignSubject& subject,
                          const ScaledLight& light, GoalSets& sets) {
  DesignWall name;
  name.kind = DesignWall::Kind::front;
  name.goal = goal;
  if (subject.front) {
    const ExactPlane plane = exact_plane(front_plane(subject));
    for (const ExactVector& arm : light.arms) {
      sets.within.push_back({space.add(scale_plane(plane, light, arm), name), true});
    }
  }
  const auto* area = std::get_if<AreaLight>(&design.light);
  if (!area || (area->two_sided && subject.points.size() > 1)) return;
  const ExactVector normal = plane_of(*area).normal;
  for (const Point3& q : subject.points) {
    // n (q - c - s arm) > 0.
    const Rational height = dot(normal, exact(q) - light.centre), rise = dot(normal, light.arms[0]);
    if (area->two_sided) {
      // In its own plane it shows its edge alone.
      if (rise != 0) sets.none.push_back(whole_plane_set(space, {rise, 0, 0}, Rational(-height), name));
      if (rise == 0 && height == 0) sets.any.emplace_back();
      continue;
    }
    sets.within.push_back({space.add(whole_plane({rise, 0, 0}, Rational(-height)), name), subject.points.size() > 1});
  }
}

}  // namespace

void add_scales(DesignSpace& space, const Design& design, std::uint32_t number, const DesignSubject& subject,
                const DesignObstacles& obstacles, GoalSets& sets) {
  const DesignGoal& goal = design.goals[number];
  const ScaledLight light(design);
  add_fronts_of_scales(space, design, number, subject, light, sets);
  std::vector<ConvexSet> dark, touched;
  for (const std::uint32_t part : parts_that_count(goal, obstacles)) {
    const SubjectShadow shadow = subject_shadow(space, subject, obstacles.obstacles.blockers[part], {number, part});
    if (shadow.umbra) dark.push_back(scales_within(space, *shadow.umbra, light));
    if (!shadow.occlusion) continue;
    if (auto set = scales_into(space, *shadow.occlusion, light, {number, part})) touched.push_back(std::move(*set));
  }
  if (goal.want == Want::lit) {
    std::ranges::move(touched, std::back_inserter(sets.none));
  } else if (goal.want == Want::dark || goal.want == Want::not_seen_from) {
    sets.any.push_back(std::move(dark));
    sets.overlapping.push_back(std::move(touched));
  } else if (subject.points.size() > 1 ||
             (goal.want == Want::penumbra && parts_that_count(goal, obstacles).size() > 1)) {
    throw DesignError("goal \"" + goal.name +
                      "\": a light with size in partial shadow is asked of a point, and penumbra of one blocker");
  } else {
    sets.any.push_back(std::move(touched));
    if (goal.want == Want::penumbra) std::ranges::move(dark, std::back_inserter(sets.none));
  }
}

}  // namespace gnomon::inverse
