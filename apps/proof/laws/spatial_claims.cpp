#include "apps/proof/laws/law_lists.h"

#include <algorithm>
#include <array>
#include <optional>

#include "apps/proof/laws/claim_cases.h"
#include "apps/proof/laws/definition.h"
#include "apps/proof/laws/enumeration.h"
#include "apps/proof/laws/law_entry.h"
#include "apps/proof/laws/visibility_definition.h"

namespace gnomon::laws {
namespace {

using Polygon = std::vector<ExactVector>;

/// A light polygon and a flat blocker in exact coordinates.
struct Figure {
  Polygon light;
  Polygon blocker;

  explicit Figure(const VisibilityCase& drawn)
      : light(vertices(drawn.light)), blocker(exact(std::get<ConvexPolygon>(drawn.blockers.front()).points())) {}

  bool is_shared(const ExactVector& p) const {
    return std::ranges::find(light, p) != light.end() && std::ranges::find(blocker, p) != blocker.end();
  }
  bool share() const {
    return std::ranges::any_of(light, [&](const ExactVector& p) { return is_shared(p); });
  }
};

Region region_of(const VisibilityCase& drawn, const ExactVector& p) {
  if (is_unlit(drawn.light, p)) return Region::unlit;
  std::vector<Walls> all;
  for (const ConvexBlocker& blocker : drawn.blockers) all.push_back(walls(blocker));
  return region_behind(all, drawn.light, p);
}

/// The claim is false of the case, or true; unless the subject errs about the point.
Verdict judged(const VisibilityCase& drawn, const Subject& subject, bool refuted, std::string_view reason) {
  const Region found = subject.visibility(drawn.light, {drawn.blockers, {}}, drawn.point).region;
  if (found != region_of(drawn, exact(drawn.point))) return verdict(false, "the point's region differs");
  return refuted ? refutes(reason) : Verdict{};
}

/// True if f = 0 in a neighbourhood of p: the umbra of a flat blocker is convex, so it holds what lies between points
/// of it.
bool is_inside_umbra(const VisibilityCase& drawn, const ExactVector& p) {
  if (region_of(drawn, p) != Region::umbra) return false;
  const auto all_dark = [&](const Rational& step) {
    const std::array steps{ExactVector{step, 0, 0}, ExactVector{0, step, 0}, ExactVector{0, 0, step}};
    return std::ranges::all_of(steps, [&](const ExactVector& s) {
      return region_of(drawn, p + s) == Region::umbra && region_of(drawn, p - s) == Region::umbra;
    });
  };
  return all_dark(Rational(1, 100)) || all_dark(Rational(1, 1000000));
}

/// The claim that a light and a blocker that share a vertex leave no umbra.
Verdict check_no_umbra(const VisibilityCase& drawn, const Subject& subject) {
  const ExactVector p = exact(drawn.point);
  if (!Figure(drawn).share() || is_unlit(drawn.light, p)) return premise_fails();
  const bool refuted = is_inside_umbra(drawn, p);
  if (refuted &&
      subject.shadow_volumes(drawn.light, std::get<ConvexPolygon>(drawn.blockers.front())).umbra_facts.empty) {
    return verdict(false, "said to have no umbra");
  }
  return judged(drawn, subject, refuted, "f = 0 at the point and around it");
}

/// A point's side of a separating plane: +1 on the blocker's side; nothing if the plane does not separate.
std::optional<int> side_with_blocker(const ExactPlane& plane, const Figure& figure, const ExactVector& p) {
  if (is_zero(plane.normal)) return std::nullopt;
  const std::optional<int> light = common_side(plane, figure.light), blocker = common_side(plane, figure.blocker);
  if (!light || !blocker || *light * *blocker > 0 || (*light == 0 && *blocker == 0)) return std::nullopt;
  return plane.side(p) * (*blocker != 0 ? *blocker : -*light);
}

/// True if p lies strictly on the blocker's side of all separating planes through edges of the one without a shared
/// vertex and vertices of the other.
bool is_inside_remaining(const Figure& figure, const ExactVector& p) {
  for (const auto& [edges, apexes] :
       {std::pair(figure.blocker, figure.light), std::pair(figure.light, figure.blocker)}) {
    for (const PolygonSide& side : sides(edges)) {
      if (figure.is_shared(side.from) || figure.is_shared(side.to)) continue;
      for (const ExactVector& apex : apexes) {
        if (side_with_blocker(plane_through(side.from, side.to, apex), figure, p).value_or(1) <= 0) return false;
      }
    }
  }
  return true;
}

/// The claim that planes of edges with a shared vertex may be left out.
Verdict check_omitted_planes(const VisibilityCase& drawn, const Subject& subject) {
  const Figure figure(drawn);
  const ExactVector p = exact(drawn.point);
  const ExactPlane plane = plane_of(figure.blocker);
  const int light_side = common_side(plane, figure.light).value_or(0);
  if (!figure.share() || light_side == 0 || is_unlit(drawn.light, p)) return premise_fails();
  const int front = common_side(plane_of(figure.light), figure.blocker).value_or(0);
  if (front == 0 || plane_of(figure.light).side(p) != front) return premise_fails();
  if (plane.side(p) != -light_side || !is_inside_remaining(figure, p)) return premise_fails();
  return judged(drawn, subject, region_of(drawn, p) == Region::lit, "f = 1 inside of all planes that are left");
}

/// The claim that all umbra of a blocker of several pieces is umbra of one of them.
Verdict check_umbra_of_pieces(const VisibilityCase& drawn, const Subject& subject) {
  const ExactVector p = exact(drawn.point);
  if (region_of(drawn, p) != Region::umbra) return premise_fails();
  const bool one_suffices = std::ranges::any_of(drawn.blockers, [&](const ConvexBlocker& piece) {
    return region_of({drawn.light, {piece}, drawn.point}, p) == Region::umbra;
  });
  return judged(drawn, subject, !one_suffices, "no piece alone hides the light, all together do");
}

/// The walls of what a convex solid hides of a point outside of it: planes of facets that it sees from their outside or
/// edge on, and planes through it that have the solid on one side.
Walls shadow_walls(const ConvexSolid& solid, const ExactVector& l) {
  const Polygon points = exact(solid.points());
  Walls result;
  for (const ExactPlane& facet : walls(solid)) {
    if (facet.side(l) >= 0) result.push_back(facet);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const ExactPlane plane = plane_through(l, points[i], points[j]);
      const std::optional<int> side = common_side(plane, points);
      if (!is_zero(plane.normal) && side) result.push_back(*side < 0 ? plane : plane.reversed());
    }
  }
  return result;
}

/// The part of a convex polygon below a plane or on it.
Polygon below(const Polygon& polygon, const ExactPlane& plane) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactVector &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Rational from = plane.height(a), to = plane.height(b);
    if (sign(from) <= 0) result.push_back(a);
    if (sign(from) * sign(to) < 0) result.push_back(a + Rational(from / (from - to)) * (b - a));
  }
  return result;
}

bool holds(const Walls& set, const ExactVector& p) {
  return std::ranges::all_of(set, [&](const ExactPlane& wall) { return wall.side(p) <= 0; });
}

/// True if the umbra meets the plane inside the solid alone. What of it lies in a square around the solid tells: a
/// convex set that leaves the solid does so inside the square.
bool umbra_crosses_inside_only(const PocketCase& drawn) {
  const ExactVector origin = exact(drawn.plane[0]);
  const ExactVector u = Rational(1000) * (exact(drawn.plane[1]) - origin);
  const ExactVector v = Rational(1000) * (exact(drawn.plane[2]) - origin);
  const ConvexBlocker& solid = drawn.visibility.blockers.front();
  Polygon slice{origin - u - v, origin + u - v, origin + u + v, origin - u + v};
  for (const ExactVector& l : vertices(drawn.visibility.light)) {
    for (const ExactPlane& wall : shadow_walls(std::get<ConvexSolid>(solid), l)) slice = below(slice, wall);
  }
  const Walls inside = walls(solid);
  return std::ranges::all_of(slice, [&](const ExactVector& p) { return holds(inside, p); });
}

/// The claim that the umbra of a solid outside of it is one region.
Verdict check_one_pocket(const PocketCase& drawn, const Subject& subject) {
  const VisibilityCase& visibility = drawn.visibility;
  const std::array points{exact(visibility.point), exact(drawn.other)};
  const Walls inside = walls(visibility.blockers.front());
  const bool two_in_umbra = std::ranges::all_of(
      points, [&](const ExactVector& p) { return !holds(inside, p) && region_of(visibility, p) == Region::umbra; });
  const ExactPlane plane = plane_through(exact(drawn.plane[0]), exact(drawn.plane[1]), exact(drawn.plane[2]));
  if (!two_in_umbra || plane.side(points[0]) * plane.side(points[1]) >= 0) return premise_fails();
  const bool refuted = umbra_crosses_inside_only(drawn);
  if (refuted && subject.shadow_volumes(visibility.light, visibility.blockers.front()).umbra_pockets < 2) {
    return verdict(false, "said to have fewer than two pockets");
  }
  return judged(visibility, subject, refuted, "f = 0 at both points, and between them only inside the solid");
}

ConvexPolygon polygon(std::vector<Point3> points) {
  return ConvexPolygon::from_points(std::move(points));
}

}  // namespace

std::vector<Law> spatial_claims() {
  const Light square = AreaLight{polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})};
  const VisibilityCase wall{square, {polygon({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}})}, {-0.1, 0.5, 0.05}};
  const VisibilityCase corner{square, {polygon({{0, 0, 0}, {0, 1, 1}, {0, -1, 1}})}, {-1, 1, 0.5}};
  const VisibilityCase board{AreaLight{polygon({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}})},
                             {polygon({{-3, -3, 2}, {-3, 3, 2}, {0, 3, 2}, {0, -3, 2}}),
                              polygon({{0, -3, 2}, {0, 1, 2}, {3, 1, 2}, {3, -3, 2}})},
                             {0, 0, 1}};
  return {
      refuted_claim<VisibilityCase>(
          {"F1", "[CF91] 4.2.3", "If the light and the blocker share an edge or a vertex, there is no umbra."}, {wall},
          pairs_that_share, check_no_umbra),
      refuted_claim<VisibilityCase>(
          {"F2", "[CF91] 4.2.2",
           "If the light and the blocker share vertices, the planes of edges with a shared vertex "
           "may be left out: the others bound the occlusion volume."},
          {corner}, pairs_that_share, check_omitted_planes),
      refuted_claim<PocketCase>({"F6", "[P93] 4.2.2.1 read for solids",
                                 "One light and one convex blocker have at most one umbra, also outside a solid."},
                                {pyramid_case({})}, pyramid_cases, check_one_pocket),
      refuted_claim<VisibilityCase>(
          {"F7", "[P93] 5.2.3 read for umbrae",
           "The umbra of a blocker of several convex pieces is the union of the umbrae of the pieces."},
          {board}, cut_boards, check_umbra_of_pieces),
  };
}

}  // namespace gnomon::laws
