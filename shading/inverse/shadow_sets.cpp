#include "shading/inverse/shadow_sets.h"

#include "geometry/spatial/prepared_pair.h"
#include "gnomon/pair.h"
#include "shading/inverse/goal_sets.h"

namespace gnomon::inverse {
namespace {

DesignWall shadow_wall(const FacetName& facet, const GoalPart& names) {
  DesignWall wall;
  wall.kind = DesignWall::Kind::shadow;
  wall.goal = names.goal;
  wall.part = names.part;
  const bool is_subject_edge = facet.kind == FacetKind::separating_light_plane;
  (is_subject_edge ? wall.subject : wall.edge) = facet.edge_index;
  (is_subject_edge ? wall.vertex : wall.subject) = facet.vertex_index;
  if (facet.kind == FacetKind::blocker_face) wall.subject.reset();
  return wall;
}

/// Nothing is hidden across a facet's plane from points on it; along the other planes what grazes is hidden from
/// points.
ConvexSet set_of(DesignSpace& space, const std::vector<HalfSpace>& half_spaces, const GoalPart& names,
                 Grazing grazing) {
  ConvexSet set;
  for (const HalfSpace& h : half_spaces) {
    const bool is_closed = h.name.kind != FacetKind::blocker_face && grazing == Grazing::hides;
    set.walls.push_back({space.add(whole_plane(h), shadow_wall(h.name, names)), is_closed});
  }
  return set;
}

/// A point in the plane of a flat blocker: what the blocker hides from it lies in that plane.
std::optional<ConvexSet> flat_shadow(DesignSpace& space, const DesignSubject& subject, const ConvexBlocker& blocker,
                                     const GoalPart& names) {
  const auto* polygon = std::get_if<ConvexPolygon>(&blocker);
  if (polygon == nullptr || subject.points.size() > 1) return std::nullopt;
  std::vector<Whole> generators;
  for (const Point3& b : polygon->points()) {
    generators.push_back(whole_point(b));
    if (b != subject.points[0]) generators.push_back(whole_direction(exact(b) - exact(subject.points[0])));
  }
  return flat_hull_set(space, std::move(generators), names);
}

}  // namespace

SubjectShadow subject_shadow(DesignSpace& space, const DesignSubject& subject, const ConvexBlocker& blocker,
                             const GoalPart& names) {
  const Light light = as_light(subject);
  if (const std::string_view refusal = pair_refusal(light, blocker); !refusal.empty()) {
    throw DesignError("a subject's vertices are not exactly in one plane, and a blocker stands across it");
  }
  const PreparedPair pair = prepared_pair(light, blocker);
  const bool is_point = subject.points.size() == 1;
  SubjectShadow result;
  if (!pair.half_spaces.umbra_empty) result.umbra = set_of(space, pair.half_spaces.umbra, names, Grazing::hides);
  if (!pair.half_spaces.occlusion_empty) {
    result.occlusion =
        set_of(space, pair.half_spaces.occlusion, names, is_point ? Grazing::hides : Grazing::counts_not);
  } else if (is_point) {
    result.occlusion = flat_shadow(space, subject, blocker, names);
    result.umbra = result.occlusion;
  }
  return result;
}

std::optional<ConvexSet> hull_set(DesignSpace& space, const std::vector<Whole>& generators, const GoalPart& names,
                                  bool is_closed) {
  const auto half_spaces = hull_half_spaces(generators);
  if (!half_spaces) return std::nullopt;
  DesignWall name;
  name.kind = DesignWall::Kind::sum;
  name.goal = names.goal;
  name.part = names.part;
  ConvexSet set;
  for (const Whole& plane : *half_spaces) set.walls.push_back({space.add(plane, name), is_closed});
  return set;
}

std::optional<ConvexSet> flat_hull_set(DesignSpace& space, std::vector<Whole> generators, const GoalPart& names) {
  Whole plane{};
  for (std::size_t i = 2; i < generators.size() && is_zero(normal_of(plane)); ++i) {
    for (std::size_t j = 1; j < i && is_zero(normal_of(plane)); ++j) {
      for (std::size_t k = 0; k < j && is_zero(normal_of(plane)); ++k) {
        plane = complement(generators[k], generators[j], generators[i]);
      }
    }
  }
  const ExactVector normal = normal_of(plane);
  if (is_zero(normal)) return std::nullopt;
  generators.push_back(whole_direction(normal));
  generators.push_back(whole_direction(Rational(-1) * normal));
  std::optional<ConvexSet> set = hull_set(space, generators, names, true);
  if (!set) set.emplace();
  DesignWall name;
  name.kind = DesignWall::Kind::sum;
  name.goal = names.goal;
  name.part = names.part;
  set->flat = space.add(plane, name);
  set->walls.push_back({*set->flat, true});
  set->walls.push_back({space.add(whole_plane(Rational(-1) * normal, Rational(-Rational(plane[3]))), name), true});
  return set;
}

ConvexSet mirror_set(DesignSpace& space, const DesignSubject& subject, const Point3& eye, std::uint32_t goal) {
  const std::vector<Point3>& q = subject.points;
  const ExactPlane plane = plane_through(exact(q[0]), exact(q[1]), exact(q[2]));
  const ExactVector e = exact(eye);
  const ExactVector mirrored = e - Rational(2 * plane.height(e) / dot(plane.normal, plane.normal)) * plane.normal;
  ConvexSet set;
  DesignWall name;
  name.kind = DesignWall::Kind::mirror;
  name.goal = goal;
  set.walls.push_back({space.add(whole_plane(Rational(-1) * plane.normal, Rational(-plane.offset)), name), false});
  for (std::size_t k = 0; k < q.size(); ++k) {
    // Seen from the mirrored eye behind the plane the corners run clockwise: their planes face inward.
    const ExactPlane side = plane_through(mirrored, exact(q[k]), exact(q[(k + 1) % q.size()]));
    const bool is_outward = side.height(exact(q[(k + 2) % q.size()])) < 0;
    name.edge = static_cast<std::uint32_t>(k);
    const Rational sign = is_outward ? 1 : -1;
    set.walls.push_back({space.add(whole_plane(sign * side.normal, Rational(sign * side.offset)), name), true});
  }
  return set;
}

}  // namespace gnomon::inverse
