#include "apps/proof/laws/law_lists.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "apps/proof/laws/cone.h"
#include "apps/proof/laws/definition.h"
#include "apps/proof/laws/enumeration.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/spatial_cases.h"

namespace gnomon::laws {
namespace {

using Polygon = std::vector<ExactVector>;

bool is_area(const Light& light) {
  return std::holds_alternative<AreaLight>(light);
}
bool is_point(const Light& light) {
  return std::holds_alternative<PointLight>(light);
}

bool in_blocker_plane(const ExactVector& p, const ConvexPolygon& blocker) {
  return plane_of(exact(blocker.points())).side(p) == 0;
}

bool holds(const ConvexVolume& volume, const Point3& p) {
  return volume.oriented_side(p) != Side::outside;
}

/// The plane of that name with the blocker on its negative side: so the light lies on the positive side of a separating
/// plane, and neither on that of a supporting one.
ExactPlane plane_named(const BlockerPlane& name, const Polygon& light, const Polygon& blocker) {
  const std::uint32_t edge = number(name.edge);
  const ExactPlane plane =
      plane_through(blocker.at(edge), blocker.at((edge + 1) % blocker.size()), light.at(number(name.vertex)));
  return plane.side(middle(blocker)) < 0 ? plane : plane.reversed();
}

ExactPlane plane_named(const LightPlane& name, const Polygon& light, const Polygon& blocker) {
  const std::uint32_t edge = number(name.edge);
  const ExactPlane plane =
      plane_through(light.at(edge), light.at((edge + 1) % light.size()), blocker.at(number(name.vertex)));
  return plane.side(middle(blocker)) < 0 ? plane : plane.reversed();
}

/// The planes of those names are what they are said to be.
template <class Names>
bool have_contact(const SpatialCase& drawn, const Names& names, Contact contact) {
  const Polygon light = vertices(drawn.light);
  const Polygon blocker = exact(drawn.blocker.points());
  return std::ranges::all_of(names, [&](const auto& name) {
    const ExactPlane plane = plane_named(name, light, blocker);
    const ExactPlane with_light_below = contact == Contact::separating ? plane.reversed() : plane;
    return common_side(plane, blocker).value_or(1) <= 0 && common_side(with_light_below, light).value_or(1) <= 0;
  });
}

/// True if the point lies on the positive side of one of the planes; for `least_side` 0 on the plane itself counts.
template <class Names>
bool beyond_one(const SpatialCase& drawn, const Names& names, int least_side) {
  const Polygon light = vertices(drawn.light);
  const Polygon blocker = exact(drawn.blocker.points());
  return std::ranges::any_of(names, [&](const auto& name) {
    return plane_named(name, light, blocker).side(exact(drawn.point)) >= least_side;
  });
}

std::optional<Rational> fraction(const SpatialCase& drawn) {
  return visible_fraction(drawn.light, drawn.blocker, exact(drawn.point));
}

Verdict check_point_shadow(const SpatialCase& drawn, const Subject& subject) {
  const ShadowVolumes volumes = subject.shadow_volumes(drawn.light, drawn.blocker);
  const ExactVector p = exact(drawn.point);
  const bool shadowed = in_blocker_plane(p, drawn.blocker) ? lies_on(p, drawn.blocker) : *fraction(drawn) == 0;
  if (holds(volumes.occlusion, drawn.point) != shadowed) return verdict(false, "the occlusion volume differs");
  return verdict(holds(volumes.umbra, drawn.point) == shadowed, "the umbra differs");
}

template <class Names>
Verdict check_beyond_separating(const SpatialCase& drawn, const Names& names) {
  if (!have_contact(drawn, names, Contact::separating)) return verdict(false, "a plane does not separate");
  const std::optional<Rational> f = fraction(drawn);
  if (!f || !beyond_one(drawn, names, is_area(drawn.light) ? 0 : 1)) return premise_fails();
  return verdict(*f == 1, "f < 1 beyond a separating plane");
}

Verdict check_beyond_separating_blocker_plane(const SpatialCase& drawn, const Subject& subject) {
  return check_beyond_separating(drawn, subject.extremal_planes(drawn.light, drawn.blocker).separating_blocker);
}

Verdict check_beyond_separating_light_plane(const SpatialCase& drawn, const Subject& subject) {
  return check_beyond_separating(drawn, subject.extremal_planes(drawn.light, drawn.blocker).separating_light);
}

Verdict check_occlusion(const SpatialCase& drawn, const Subject& subject) {
  const Side side = subject.shadow_volumes(drawn.light, drawn.blocker).occlusion.oriented_side(drawn.point);
  const std::optional<Rational> f = fraction(drawn);
  if (!f) return verdict(side == Side::outside, "an unlit point is not outside");
  if (side == Side::inside) return verdict(*f < 1, "f = 1 inside");
  if (side == Side::outside || is_area(drawn.light)) return verdict(*f == 1, "f < 1 outside or on the boundary");
  return verdict(true, "");
}

Verdict check_hull_of_shadows(const SpatialCase& drawn, const Subject& subject) {
  const bool expected =
      is_in_hull_of_vertex_shadows(exact(drawn.point), vertices(drawn.light), exact(drawn.blocker.points()));
  const ShadowVolumes volumes = subject.shadow_volumes(drawn.light, drawn.blocker);
  return verdict(holds(volumes.occlusion, drawn.point) == expected,
                 expected ? "in the hull, not in the volume" : "in the volume, not in the hull");
}

Verdict check_difference_cone(const SpatialCase& drawn, const Subject& subject) {
  const bool expected = is_in_difference_cone(exact(drawn.point), vertices(drawn.light), exact(drawn.blocker.points()));
  const ShadowVolumes volumes = subject.shadow_volumes(drawn.light, drawn.blocker);
  return verdict(holds(volumes.occlusion, drawn.point) == expected,
                 expected ? "in the set, not in the volume" : "in the volume, not in the set");
}

Verdict check_beyond_supporting_plane(const SpatialCase& drawn, const Subject& subject) {
  const ExtremalPlanes planes = subject.extremal_planes(drawn.light, drawn.blocker);
  if (!have_contact(drawn, planes.supporting_blocker, Contact::supporting)) {
    return verdict(false, "a plane does not support");
  }
  const std::optional<Rational> f = fraction(drawn);
  if (!f || !beyond_one(drawn, planes.supporting_blocker, 1)) return premise_fails();
  return verdict(*f > 0, "f = 0 beyond a supporting plane");
}

Verdict check_umbra(const SpatialCase& drawn, const Subject& subject) {
  const bool inside = holds(subject.shadow_volumes(drawn.light, drawn.blocker).umbra, drawn.point);
  const ExactVector p = exact(drawn.point);
  const std::optional<Rational> f = fraction(drawn);
  if (!f) return verdict(!inside, "an unlit point is not outside");
  if (in_blocker_plane(p, drawn.blocker)) return verdict(inside == lies_on(p, drawn.blocker), "not the blocker itself");
  return verdict(inside == (*f == 0), inside ? "f > 0 in the umbra" : "f = 0 outside the umbra");
}

/// The same light with one more vertex on an edge, or the other way round; the light itself where that would round.
Light described_otherwise(const Light& light) {
  if (const auto* linear = std::get_if<LinearLight>(&light)) return LinearLight{linear->end, linear->start};
  const auto* area = std::get_if<AreaLight>(&light);
  if (!area) return light;
  std::vector<Point3> points(area->polygon.points().begin(), area->polygon.points().end());
  const Point3 a = points.front();
  const Point3 b = points.back();
  const Point3 between{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
  if (Rational(2) * exact(between) == exact(a) + exact(b)) points.insert(points.begin(), between);
  if (ConvexPolygon::defect(points)) return light;
  return AreaLight{ConvexPolygon::from_points(points), area->two_sided};
}

Verdict check_umbra_as_intersection(const SpatialCase& drawn, const Subject& subject) {
  const Polygon light = vertices(drawn.light);
  const auto in_every_shadow = [&](const ExactVector& p) {
    return std::ranges::all_of(light, [&](const auto& l) { return segment_meets(p, l, drawn.blocker); });
  };
  const ExactVector p = exact(drawn.point);
  const ExactVector q = exact(drawn.other);
  const bool expected = in_every_shadow(p);
  const bool inside = holds(subject.shadow_volumes(drawn.light, drawn.blocker).umbra, drawn.point);
  if (inside != expected) return verdict(false, "the umbra is not the intersection of the vertex shadows");
  const Light otherwise = described_otherwise(drawn.light);
  const bool inside_otherwise = holds(subject.shadow_volumes(otherwise, drawn.blocker).umbra, drawn.point);
  if (inside_otherwise != expected) return verdict(false, "the umbra depends on more than the light's hull");
  const bool both = expected && in_every_shadow(q);
  return verdict(!both || in_every_shadow(Rational(1, 2) * (p + q)), "the intersection is not convex");
}

bool same_planes(ExtremalPlanes found, ExtremalPlanes expected, const Light& light) {
  // The two planes through a linear light stand in no promised order.
  const auto by_vertex = [](const LightPlane& a, const LightPlane& b) { return number(a.vertex) < number(b.vertex); };
  if (std::holds_alternative<LinearLight>(light)) {
    std::ranges::sort(found.separating_light, by_vertex);
    std::ranges::sort(expected.separating_light, by_vertex);
  }
  return found.separating_blocker == expected.separating_blocker &&
         found.separating_light == expected.separating_light && found.supporting_blocker == expected.supporting_blocker;
}

Verdict check_counts(const SpatialCase& drawn, const Subject& subject) {
  const ExtremalPlanes planes = subject.extremal_planes(drawn.light, drawn.blocker);
  const PlaneCounts counts = plane_counts(drawn.light, drawn.blocker);
  const std::size_t separating = planes.separating_blocker.size() + planes.separating_light.size();
  if (planes.supporting_blocker.size() != counts.blocker_sides) return verdict(false, "supporting planes: not m");
  if (separating != counts.light_sides + counts.blocker_sides - counts.coplanar_pairs) {
    return verdict(false, "separating planes: not n + m - k");
  }
  return verdict(same_planes(planes, enumerated_planes(drawn.light, drawn.blocker), drawn.light),
                 "the planes are not those that trying every edge with every vertex finds");
}

Verdict check_bounded_umbra(const SpatialCase& drawn, const Subject& subject) {
  const bool unbounded = rays_meet_blocker_in_parallel(vertices(drawn.light), exact(drawn.blocker.points()));
  const VolumeFacts facts = subject.shadow_volumes(drawn.light, drawn.blocker).umbra_facts;
  if (facts.empty || facts.components != 1) return verdict(false, "there is not exactly one umbra");
  return verdict(facts.bounded != unbounded, unbounded ? "said to be bounded" : "said to be unbounded");
}

/// A ray from a blocker edge along which f stays between 0 and 1: it starts inside the edge and runs away from a point
/// of the light that is strictly between the two extremal planes of the edge.
bool penumbra_holds_ray(const SpatialCase& drawn, const PolygonSide& edge, const BlockerPlane& separating,
                        const BlockerPlane& supporting) {
  const Polygon light = vertices(drawn.light);
  const ExactVector start = Rational(1, 2) * (edge.from + edge.to);
  const ExactVector l = Rational(1, 2) * (light[number(separating.vertex)] + light[number(supporting.vertex)]);
  return std::ranges::all_of(std::array{-20, 0, 20, 200}, [&](int exponent) {
    Rational step = 1;
    for (int i = 0; i < std::abs(exponent); ++i) step *= exponent < 0 ? Rational(1, 2) : Rational(2);
    const std::optional<Rational> f = visible_fraction(drawn.light, drawn.blocker, start + step * (start - l));
    return f && *f > 0 && *f < 1;
  });
}

Verdict check_unbounded_penumbra(const SpatialCase& drawn, const Subject& subject) {
  const ShadowVolumes volumes = subject.shadow_volumes(drawn.light, drawn.blocker);
  if (volumes.occlusion_facts.empty || volumes.occlusion_facts.bounded) return verdict(false, "occlusion: bounded");
  if (is_point(drawn.light)) return verdict(volumes.penumbra_facts.empty, "the penumbra of a point is not empty");
  if (volumes.penumbra_facts.empty || volumes.penumbra_facts.bounded) return verdict(false, "penumbra: bounded");
  const ExtremalPlanes planes = enumerated_planes(drawn.light, drawn.blocker);
  const std::vector<PolygonSide> edges = sides(exact(drawn.blocker.points()));
  bool found = false;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (planes.separating_blocker[i] == planes.supporting_blocker[i]) continue;
    found = true;
    if (!penumbra_holds_ray(drawn, edges[i], planes.separating_blocker[i], planes.supporting_blocker[i])) {
      return verdict(false, "a ray leaves the penumbra");
    }
  }
  return verdict(found, "every edge has one extremal plane only");
}

/// How many tangent planes through the line of a linear light hold a blocker edge and an unbounded part of the umbra.
std::size_t closed_off_planes(const SpatialCase& drawn) {
  const Polygon light = vertices(drawn.light);
  const Polygon blocker = exact(drawn.blocker.points());
  return std::size_t(std::ranges::count_if(sides(blocker), [&](const PolygonSide& edge) {
    const ExactPlane plane = plane_through(edge.from, edge.to, light[0]);
    return plane.side(light[1]) == 0 && rays_meet_blocker_in_parallel(light, blocker, plane);
  }));
}

Verdict check_penumbra_components(const SpatialCase& drawn, const Subject& subject) {
  const bool line_misses =
      std::holds_alternative<LinearLight>(drawn.light) && plane_counts(drawn.light, drawn.blocker).light_sides == 2;
  const std::uint32_t expected = line_misses && closed_off_planes(drawn) == 2 ? 2 : 1;
  const VolumeFacts facts = subject.shadow_volumes(drawn.light, drawn.blocker).penumbra_facts;
  return verdict(facts.components == expected, "expected " + std::to_string(expected) + " penumbra volumes");
}

/// The generator of laws about those lights.
auto pairs(Lights lights, View view = View::any) {
  return [=](Domain domain) { return spatial_cases(domain, lights, view); };
}

}  // namespace

std::vector<Law> spatial_laws() {
  return {
      law({"S1", "[CF91] Theorem 1",
           "A point light off the plane of a flat blocker is hidden exactly in the intersection of B- and the "
           "half-spaces of the (light, edge) planes; of the blocker's plane only the blocker itself belongs to it."},
          pairs(Lights::points), check_point_shadow),
      law({"S2", "[CF91] Lemma 1",
           "A separating blocker plane has L and B on opposite closed sides, and on its positive side f = 1; for an "
           "area light on the plane itself too."},
          pairs(Lights::all), check_beyond_separating_blocker_plane),
      law({"S3", "[CF91] Lemma 2",
           "A separating light plane has L and B on opposite closed sides, and on its positive side f = 1; for an area "
           "light on the plane itself too."},
          pairs(Lights::with_extent, View::before_light), check_beyond_separating_light_plane),
      law({"S4", "[CF91] Theorem 2",
           "In B- and all separating half-spaces f < 1 strictly inside and f = 1 strictly outside; on the boundary f "
           "= 1 for an area light, while a point or linear light may be hidden there; unlit points are strictly "
           "outside."},
          pairs(Lights::all), check_occlusion),
      law({"S5", "[P93] 4.2.3.1", "The occlusion volume is the convex hull of the vertex shadows."}, pairs(Lights::all),
          check_hull_of_shadows),
      law({"S6", "own", "The occlusion volume is B plus the cone of the differences b - l, boundary included."},
          pairs(Lights::all), check_difference_cone),
      law({"S7", "[CF91] Lemma 3",
           "A supporting blocker plane has L and B on one closed side, and on its positive side f > 0."},
          pairs(Lights::all), check_beyond_supporting_plane),
      law({"S8", "[CF91] Theorem 3",
           "Off the blocker's plane f = 0 exactly in the intersection of B- and all supporting half-spaces, boundary "
           "included; of the blocker's plane only the blocker itself belongs to it; unlit points are outside."},
          pairs(Lights::all), check_umbra),
      law({"S9", "own",
           "The umbra is the intersection of the vertex shadows; it depends only on the light's hull, and is convex."},
          pairs(Lights::all), check_umbra_as_intersection),
      law({"S10", "own",
           "There are m supporting blocker planes and n + m - k separating planes (n = 0 for a point light, and for a "
           "linear light whose line meets the blocker), named as trying every edge with every vertex names them."},
          pairs(Lights::all), check_counts),
      law({"S12", "own",
           "There is one umbra; it is unbounded exactly if the rays of one direction from all light vertices meet the "
           "blocker."},
          pairs(Lights::all), check_bounded_umbra),
      law({"S13", "[P93] 4.1",
           "The penumbra of an area or linear light is unbounded: rays leave a blocker's edge on which 0 < f < 1 "
           "everywhere. That of a point light is empty."},
          pairs(Lights::all), check_unbounded_penumbra),
      law({"S14", "own",
           "The penumbra of an area light is one, that of a linear light one too, or two exactly when its line misses "
           "the blocker and both tangent planes through it hold a blocker edge and an unbounded part of the umbra."},
          pairs(Lights::with_extent), check_penumbra_components),
  };
}

}  // namespace gnomon::laws
