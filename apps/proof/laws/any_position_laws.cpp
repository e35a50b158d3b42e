#include "apps/proof/laws/law_lists.h"

#include <algorithm>
#include <span>
#include <sstream>

#include "apps/proof/laws/any_pair.h"
#include "apps/proof/laws/cone.h"
#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/meeting.h"
#include "gnomon/shadow_volume.h"
#include "gnomon/visibility.h"

namespace gnomon::laws {
namespace {

using Polygon = std::vector<ExactVector>;

bool is_rounded(const Light& light) {
  const auto* area = std::get_if<AreaLight>(&light);
  return area && !area->polygon.is_flat();
}

bool is_directional(const Light& light) {
  return std::holds_alternative<DirectionalLight>(light);
}

/// The premise of laws about the volumes as intersections and sums: an ordinary pair, of which the light meets the
/// blocker in nothing that could be measured.
bool is_ordinary(const AnyPair& drawn, const Walls& blocker) {
  if (is_directional(drawn.light)) {
    const auto plane = plane_of(drawn.blocker);
    return !plane || sign(dot(plane->normal, exact(std::get<DirectionalLight>(drawn.light).direction))) != 0;
  }
  return !are_coplanar(drawn.light, drawn.blocker) && reaches_front(drawn.light, drawn.blocker) &&
         (is_rounded(drawn.light) || !meet_measurably(drawn.light, blocker));
}

bool is_in_front(const Light& light, const ExactVector& p) {
  const std::optional<ExactPlane> front = front_of(light);
  return !front || front->side(p) >= 0;
}

bool is_in_shadow_of_directions(const ExactVector& p, const ExactVector& direction, const Polygon& blocker) {
  std::vector<ExactColumn> generators = {{direction.x, direction.y, direction.z, Rational(0)}};
  for (const ExactVector& b : blocker) generators.push_back({b.x, b.y, b.z, Rational(1)});
  return is_in_cone(generators, {p.x, p.y, p.z, Rational(1)});
}

bool is_in_sum(const AnyPair& drawn, const ExactVector& p) {
  const Polygon blocker = vertices_of(drawn.blocker);
  if (const auto* sun = std::get_if<DirectionalLight>(&drawn.light)) {
    return is_in_shadow_of_directions(p, exact(sun->direction), blocker);
  }
  return is_in_front(drawn.light, p) && is_in_difference_cone(p, vertices_of(drawn.light), blocker);
}

bool lies_in(const ConvexVolume& volume, const Point3& p) {
  return volume.oriented_side(p) != Side::outside;
}

Verdict check_difference_cone(const AnyPair& drawn, const Subject& subject) {
  if (!is_ordinary(drawn, walls(drawn.blocker))) return premise_fails();
  const Point3& p = drawn.points[0];
  const bool expected = is_in_sum(drawn, exact(p));
  return verdict(lies_in(subject.shadow_volumes(drawn.light, drawn.blocker).occlusion, p) == expected,
                 expected ? "in the set, not in the volume" : "in the volume, not in the set");
}

/// The light's vertices that are no points of the blocker.
Polygon vertices_outside(const AnyPair& drawn, const Walls& blocker) {
  Polygon result = vertices_of(drawn.light);
  std::erase_if(result, [&](const ExactVector& l) { return holds(blocker, l); });
  return result;
}

bool is_in_every_shadow(const AnyPair& drawn, const Walls& blocker, const ExactVector& p) {
  if (holds(blocker, p)) return true;
  if (const auto* sun = std::get_if<DirectionalLight>(&drawn.light)) {
    return is_blocked_towards(blocker, p, Rational(-1) * exact(sun->direction));
  }
  return std::ranges::all_of(vertices_outside(drawn, blocker),
                             [&](const auto& l) { return is_blocked(blocker, p, l); });
}

Verdict check_intersection_of_shadows(const AnyPair& drawn, const Subject& subject) {
  const Walls blocker = walls(drawn.blocker);
  if (!is_ordinary(drawn, blocker)) return premise_fails();
  const ConvexVolume umbra = subject.shadow_volumes(drawn.light, drawn.blocker).umbra;
  if (umbra.empty) return premise_fails();
  const ExactVector p = exact(drawn.points[0]);
  const bool expected = is_in_front(drawn.light, p) && is_in_every_shadow(drawn, blocker, p);
  return verdict(lies_in(umbra, drawn.points[0]) == expected,
                 expected ? "in every vertex shadow, not in the umbra" : "in the umbra, not in every vertex shadow");
}

/// Points inside a flat blocker, none of them behind a one-sided light if the blocker has others; not all of them in
/// the light's plane.
Polygon points_inside(const AnyPair& drawn) {
  const Polygon corners = vertices_of(drawn.blocker);
  Polygon result = {middle(corners)};
  for (const ExactVector& corner : corners) result.push_back(Rational(1, 2) * (corner + result[0]));
  const std::optional<ExactPlane> front = front_of(drawn.light);
  if (!front) return result;
  const auto height = [&](const ExactVector& b) -> Rational { return front->height(b); };
  const ExactVector foremost = *std::ranges::max_element(corners, {}, height);
  for (ExactVector& p : result) {
    for (int i = 0; i < 1200 && front->side(p) <= 0; ++i) p = Rational(1, 2) * (p + foremost);
  }
  return result;
}

/// True if there is umbra very near to the blocker, on one side of its plane or the other: nearer than the square of
/// the smallest double, by which a blocker may reach the light's front.
bool is_dark_beside(const AnyPair& drawn, const Walls& blocker, const ExactPlane& plane) {
  const Rational small = 0x1p-800;
  const Rational little = small * small * small;
  return std::ranges::any_of(points_inside(drawn), [&](const ExactVector& p) {
    return std::ranges::any_of(std::array{-1, 1}, [&](int side) {
      return region_behind({blocker}, drawn.light, p + Rational(side * little) * plane.normal) == Region::umbra;
    });
  });
}

Verdict check_umbra_has_interior(const AnyPair& drawn, const Subject& subject) {
  const std::optional<ExactPlane> plane = plane_of(drawn.blocker);
  if (!plane || is_directional(drawn.light) || are_coplanar(drawn.light, drawn.blocker)) return premise_fails();
  const Walls blocker = walls(drawn.blocker);
  const Polygon light = vertices_of(drawn.light);
  const bool expected =
      common_side(*plane, light).has_value() && reaches_front(drawn.light, drawn.blocker) &&
      std::ranges::all_of(light, [&](const ExactVector& l) { return plane->side(l) != 0 || holds(blocker, l); });
  if (subject.shadow_volumes(drawn.light, drawn.blocker).umbra.empty == expected) {
    return verdict(false, expected ? "said to be empty" : "said to have an interior");
  }
  if (!reaches_front(drawn.light, drawn.blocker)) return verdict(true, "");
  const bool is_dark = is_dark_beside(drawn, blocker, *plane);
  return verdict(is_dark == expected, expected ? "f > 0 behind the blocker" : "f = 0 behind the blocker");
}

Verdict check_bounded_umbra(const AnyPair& drawn, const Subject& subject) {
  if (is_directional(drawn.light)) return premise_fails();
  const Walls blocker = walls(drawn.blocker);
  if (!is_ordinary(drawn, blocker)) return premise_fails();
  const ShadowVolumes volumes = subject.shadow_volumes(drawn.light, drawn.blocker);
  if (volumes.umbra_facts.empty) return premise_fails();
  const bool unbounded =
      parallel_rays_meet(vertices_outside(drawn, blocker), vertices_of(drawn.blocker), front_of(drawn.light));
  return verdict(volumes.umbra_facts.bounded != unbounded, unbounded ? "said to be bounded" : "said to be unbounded");
}

Verdict check_penumbra_components(const AnyPair& drawn, const Subject& subject) {
  const std::optional<ExactPlane> plane = plane_of(drawn.blocker);
  const auto* area = std::get_if<AreaLight>(&drawn.light);
  if (!plane || !area || are_coplanar(drawn.light, drawn.blocker)) return premise_fails();
  if (const auto front = front_of(drawn.light)) {
    const Polygon points = vertices_of(drawn.blocker);
    if (!std::ranges::all_of(points, [&](const ExactVector& b) { return front->side(b) >= 0; })) return premise_fails();
    if (!reaches_front(drawn.light, drawn.blocker)) return premise_fails();
  }
  const std::uint32_t expected = common_side(*plane, vertices_of(drawn.light)) ? 1 : 2;
  const VolumeFacts facts = subject.shadow_volumes(drawn.light, drawn.blocker).penumbra_facts;
  return verdict(facts.components == expected, "expected " + std::to_string(expected) + " penumbra volumes");
}

/// The light [-x, x] x [-y, y] at height z above the solid between (-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0) and
/// (0, 0, -depth), and a point, which is moved to where the law asks for it.
struct SolidPocketCase {
  double x;
  double y;
  double z;
  double depth;
  Point3 point;

  Light light() const {
    return AreaLight{ConvexPolygon::from_points({{-x, -y, z}, {-x, y, z}, {x, y, z}, {x, -y, z}})};
  }
  ConvexBlocker solid() const {
    return ConvexSolid::hull_of({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, -depth}});
  }
};

std::string description(const SolidPocketCase& drawn) {
  std::ostringstream out;
  out.precision(17);
  out << "light: " << drawn.x << " by " << drawn.y << " at height " << drawn.z << ", depth " << drawn.depth
      << ", point {" << drawn.point.x << ", " << drawn.point.y << ", " << drawn.point.z << "}\n";
  return out.str();
}

Example example(const SolidPocketCase& drawn) {
  const ConvexBlocker solid = drawn.solid();
  return spatial_example(drawn.light(), std::span(&solid, 1), {drawn.point});
}

void count_regions(const SolidPocketCase& drawn, Census& census) {
  census.add(shadow_volumes(drawn.light(), drawn.solid()));
}

rc::Gen<SolidPocketCase> pocket_cases(Domain domain) {
  return rc::gen::exec([=] {
    const double unit = domain == Domain::random ? 1 : 1 + 0x1p-50 * draw(-4, 4);
    return SolidPocketCase{0.25 * draw(1, 24) * unit,
                           0.25 * draw(1, 8) * unit,
                           0.25 * draw(1, 8),
                           0.25 * draw(1, 8) * unit,
                           {0.125 * draw(-16, 16), 0.125 * draw(-16, 16), -0.125 * draw(1, 32)}};
  });
}

/// A side of the solid that looks along an axis shows itself to the light's edge at that distance on the axis.
bool is_seen(double distance, const SolidPocketCase& drawn) {
  return Rational(drawn.depth) * Rational(distance) >= Rational(drawn.depth) + Rational(drawn.z);
}

Verdict check_pockets(const SolidPocketCase& drawn, const Subject& subject) {
  const bool two = is_seen(drawn.x, drawn) && !is_seen(drawn.y, drawn);
  const std::uint32_t pockets = subject.shadow_volumes(drawn.light(), drawn.solid()).umbra_pockets;
  const std::uint32_t expected = two ? 2 : !is_seen(drawn.x, drawn) ? 1 : is_seen(drawn.y, drawn) ? 0 : 2;
  if (is_seen(drawn.y, drawn) && !is_seen(drawn.x, drawn)) return verdict(pockets == 2, "expected two pockets");
  if (pockets != expected) return verdict(false, "expected " + std::to_string(expected) + " pockets");
  if (!two) return premise_fails();
  // Two pockets: behind the middles of two opposite sides, and a plane between them without umbra outside the solid.
  const Walls solid = walls(drawn.solid());
  ExactVector between = exact(drawn.point);
  between.y = 0;
  if (!holds(solid, between) && region_behind({solid}, drawn.light(), between) == Region::umbra) {
    return verdict(false, "f = 0 between the pockets");
  }
  const Rational little(1, 1 << 20);
  const Rational depth(drawn.depth);
  const bool dark = std::ranges::all_of(std::array{-1, 1}, [&](int side) {
    const ExactVector out{0, side * (Rational(1, 2) + little * depth), -depth / 2 - little};
    return is_seen(drawn.y * (1 + 0x1p-10), drawn) || region_behind({solid}, drawn.light(), out) == Region::umbra;
  });
  return verdict(dark, "f > 0 in a pocket");
}

/// Several parts of one blocker, most of which share vertices.
struct ConcaveCase {
  Light light;
  std::vector<ConvexBlocker> parts;
  Point3 point;
};

std::string description(const ConcaveCase& drawn) {
  std::string text;
  for (const ConvexBlocker& part : drawn.parts) text += description(AnyPair{drawn.light, part, {drawn.point}});
  return text;
}

Example example(const ConcaveCase& drawn) {
  return spatial_example(drawn.light, drawn.parts, {drawn.point});
}

void count_regions(const ConcaveCase& drawn, Census& census) {
  census.add_point(exact_visibility(drawn.light, {drawn.parts, {}}, drawn.point).region);
}

AnyPair draw_ordinary_pair(Domain domain) {
  const auto light = static_cast<PairLightKind>(draw(0, 4));
  return draw_any_pair(domain, light, static_cast<PairBlockerKind>(draw(0, 2)), 1);
}

rc::Gen<ConcaveCase> concave_cases(Domain domain) {
  return rc::gen::exec([=] {
    const AnyPair pair = draw_ordinary_pair(domain);
    ConcaveCase result{pair.light, {pair.blocker}, pair.points[0]};
    std::vector<Point3> pool =
        std::visit([](const auto& shape) { return std::vector<Point3>(shape.points().begin(), shape.points().end()); },
                   pair.blocker);
    for (int i = draw(1, 3); i > 0; --i) {
      const Point3 a = pool[std::size_t(draw(0, 2))];
      const double x = a.x + draw(-3, 3), y = a.y + draw(-3, 3);
      pool.push_back({x, y, a.z + draw(-3, 3)});
    }
    for (int i = draw(1, 3); i > 0; --i) {
      std::vector<Point3> triangle;
      for (int k = 0; k < 3; ++k) triangle.push_back(pool[std::size_t(draw(0, int(pool.size()) - 1))]);
      if (!ConvexPolygon::defect(triangle))
        result.parts.push_back(convex_blocker(ConvexPolygon::from_points(triangle)));
    }
    return result;
  });
}

/// Where single points follow no volume: in the plane of a flat part.
bool is_on_a_flat_part(const ConcaveCase& drawn, const ExactVector& p) {
  return std::ranges::any_of(drawn.parts, [&](const ConvexBlocker& part) {
    const auto plane = plane_of(part);
    return plane && plane->side(p) == 0;
  });
}

Verdict check_union_of_shadows(const ConcaveCase& drawn, const Subject& subject) {
  const ExactVector p = exact(drawn.point);
  if (drawn.parts.size() < 2 || is_unlit(drawn.light, p) || is_on_a_flat_part(drawn, p)) return premise_fails();
  std::vector<Walls> blockers;
  bool inside = false;
  bool on_boundary = false;
  for (const ConvexBlocker& part : drawn.parts) {
    blockers.push_back(walls(part));
    const Side side = subject.convex_hull_shadow_volume(drawn.light, part).oriented_side(drawn.point);
    inside = inside || side == Side::inside;
    on_boundary = on_boundary || side == Side::boundary;
  }
  if (!inside && on_boundary) return premise_fails();
  const bool is_lit = region_behind(blockers, drawn.light, p) == Region::lit;
  return verdict(inside != is_lit, is_lit ? "lit inside a volume" : "in shadow outside of all volumes");
}

/// Pairs of any kind; those of flat blockers only.
rc::Gen<AnyPair> pairs(Domain domain) {
  return rc::gen::exec([=] {
    const auto light = static_cast<PairLightKind>(draw(0, 5));
    return draw_any_pair(domain, light, static_cast<PairBlockerKind>(draw(0, 2)), 1);
  });
}

rc::Gen<AnyPair> flat_pairs(Domain domain) {
  return rc::gen::exec([=] {
    const auto light = static_cast<PairLightKind>(draw(2, 4));
    return draw_any_pair(domain, light, PairBlockerKind::flat_polygon, 1);
  });
}

}  // namespace

std::vector<Law> any_position_laws() {
  return {
      law({"S6_any", "own",
           "In any position, flat or solid, the occlusion volume is B plus the cone of the differences b - l, in front "
           "of a one-sided light and boundary included, unless L meets B in what has a measure or lies in its plane."},
          pairs, check_difference_cone),
      law({"S9_any", "own",
           "In any position, if L meets B in nothing that has a measure, an umbra with an interior is the intersection "
           "of the shadows of the light vertices that are not in B, in front of a one-sided light."},
          pairs, check_intersection_of_shadows),
      law({"S11", "own",
           "The umbra of a flat blocker has an interior exactly if L lies in one closed side of its plane and meets "
           "the plane in points of B only; of a one-sided light, if B also reaches the open front."},
          flat_pairs, check_umbra_has_interior),
      law({"S12_any", "own",
           "The umbra is unbounded exactly if the rays of one direction from all light vertices outside the blocker "
           "meet it; of a one-sided light, of a direction that does not lead behind it."},
          pairs, check_bounded_umbra),
      law({"S14_any", "own",
           "The penumbra of an area light before a flat blocker is one, or two where the light crosses its plane."},
          flat_pairs, check_penumbra_components),
      law({"S15", "own",
           "The umbra without the solid may fall into pockets: behind each side of an upside-down pyramid that the "
           "light does not see there is umbra, and no umbra joins opposite ones around a side that it sees."},
          pocket_cases, check_pockets),
      law({"M4", "[P93] 5.2.3", "The shadow of a concave blocker is the union of the occlusion volumes of its parts."},
          concave_cases, check_union_of_shadows),
  };
}

}  // namespace gnomon::laws
