#include "apps/proof/laws/visibility_cases.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/exact.h"
#include "apps/proof/laws/pair_generator.h"
#include "apps/proof/laws/point_text.h"
#include "gnomon/pair.h"
#include "gnomon/shadow_volume.h"
#include "gnomon/visibility.h"

namespace gnomon::laws {
namespace {

using Points = std::vector<Point3>;

/// A shape as a list of vertices, which are easier to move about.
struct Outline {
  Points points;
  bool flat = false;  ///< has to stay exactly so
};

Point3 draw_vector(int reach) {
  const double x = draw(-reach, reach);
  const double y = draw(-reach, reach);
  return {x, y, double(draw(-reach, reach))};
}

template <class T>
const T& draw_from(const std::vector<T>& choices) {
  return choices[std::size_t(draw(0, int(choices.size()) - 1))];
}

/// The vertices of a polygon with one of them moved off the plane by very little.
Points draw_rounded_points(double stretch) {
  Points points = draw_flat_points(stretch);
  Point3& p = points[std::size_t(draw(0, int(points.size()) - 1))];
  p = moved(p, 0x1p-36, draw_vector(1));
  if (ConvexPolygon::defect(points) || ConvexPolygon::from_points(points).is_flat()) {
    return {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0x1p-36}};
  }
  return points;
}

/// A pyramid over a polygon, a slanted prism, or these with points inside facets and edges.
Points draw_solid_points(double stretch) {
  const Points base = draw_flat_points(stretch);
  Points points = base;
  const Point3 up = draw_vector(3);
  if (once_in(2)) {
    points.push_back(moved(base[0], 1, up));
  } else {
    for (const Point3& p : base) points.push_back(moved(p, 1, up));
  }
  if (once_in(3)) points.push_back(moved(moved(base[0], 0.5, moved(base[1], -1, base[0])), 0.5, up));
  try {
    ConvexSolid::hull_of(points);
  } catch (const std::exception&) {
    return {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  }
  return points;
}

Outline draw_light(LightKind kind, double stretch) {
  switch (kind) {
    case LightKind::point:
      return {{draw_vector(4)}};
    case LightKind::direction: {
      const Point3 direction = draw_vector(3);
      return {{direction == Point3{} ? Point3{0, 0, -1} : direction}};
    }
    case LightKind::segment: {
      const Point3 start = draw_vector(4);
      const Point3 step = draw_vector(3);
      return {{start, moved(start, stretch, step == Point3{} ? Point3{1, 0, 0} : step)}};
    }
    case LightKind::polygon:
      return {draw_flat_points(stretch), true};
    case LightKind::rounded_polygon:
      break;
  }
  return {draw_rounded_points(stretch)};
}

Outline draw_blocker(BlockerKind kind, double stretch) {
  if (kind == BlockerKind::polygon) return {draw_flat_points(stretch), true};
  return {kind == BlockerKind::solid ? draw_solid_points(stretch) : draw_rounded_points(stretch)};
}

ConvexBlocker blocker_of(const Outline& outline, BlockerKind kind) {
  if (kind == BlockerKind::solid) return ConvexSolid::hull_of(outline.points);
  return convex_blocker(ConvexPolygon::from_points(outline.points));
}

Light light_of(const Outline& outline, LightKind kind, bool two_sided) {
  const Points& p = outline.points;
  if (kind == LightKind::point) return PointLight{p[0]};
  if (kind == LightKind::direction) return DirectionalLight{p[0]};
  if (kind == LightKind::segment) return LinearLight{p[0], p[1]};
  return AreaLight{ConvexPolygon::from_points(p), two_sided};
}

/// Shapes and a point in one place, to be bent together.
struct Draft {
  LightKind light_kind;
  std::vector<BlockerKind> blocker_kinds;
  Outline light;
  std::vector<Outline> blockers;
  Point3 point;
};

void shift(Points& points, double s, const Point3& step) {
  for (Point3& p : points) p = moved(p, s, step);
}

Points all_points(const Draft& draft) {
  Points all;
  if (draft.light_kind != LightKind::direction) all = draft.light.points;
  for (const Outline& blocker : draft.blockers) all.insert(all.end(), blocker.points.begin(), blocker.points.end());
  return all;
}

/// A vertex, or half way or another share of the way to a second and a third.
Point3 draw_between(const Points& points) {
  const Point3& a = draw_from(points);
  const double s = draw(0, 4) / 4.0;
  const double t = once_in(2) ? 0 : draw(0, 4) / 8.0;
  return moved(moved(a, s, moved(draw_from(points), -1, a)), t, moved(draw_from(points), -1, a));
}

/// A point that a point of a blocker hides from one of the light, or that they are in line with.
Point3 draw_shadowed_point(const Draft& draft) {
  const Point3 b = draw_between(draw_from(draft.blockers).points);
  const Point3 l = draw_between(draft.light.points);
  const Point3 away = draft.light_kind == LightKind::direction ? l : moved(b, -1, l);
  return moved(b, draw(0, 8) / 4.0, away);
}

/// A point of the plane through three vertices, often of a line through two, or a vertex.
Point3 draw_related_point(const Draft& draft) {
  const Points all = all_points(draft);
  const Point3& a = draw_from(all);
  const double s = once_in(4) ? 0 : draw(-4, 6) / 2.0;
  const double t = once_in(2) ? 0 : draw(-4, 6) / 2.0;
  return moved(moved(a, s, moved(draw_from(all), -1, a)), t, moved(draw_from(all), -1, a));
}

Point3 draw_point(const Draft& draft) {
  if (!once_in(3)) return draw_shadowed_point(draft);
  return once_in(3) ? draw_vector(8) : draw_related_point(draft);
}

/// Turns the face of an area light to the point.
void face(Points& polygon, const Point3& p) {
  const ConvexPolygon light = ConvexPolygon::from_points(polygon);
  if (plane_of(exact(light.points())).side(exact(p)) < 0) std::ranges::reverse(polygon);
}

/// Leaves flat polygons exactly flat: they move as a whole, by amounts that their coordinates can take.
void bend(Draft& draft) {
  if (once_in(3)) {
    const Point3 step = draw_vector(1);
    for (Outline& blocker : draft.blockers) {
      if (once_in(2)) shift(blocker.points, 0x1p-40, step);
    }
  }
  const bool far_away = once_in(3);
  const auto move_away = [](Point3& p) { p = {1e8 + p.x * 0x1p-20, 1e8 + p.y * 0x1p-20, 1e8 - p.z * 0x1p-20}; };
  if (far_away) {
    if (draft.light_kind != LightKind::direction) std::ranges::for_each(draft.light.points, move_away);
    for (Outline& blocker : draft.blockers) std::ranges::for_each(blocker.points, move_away);
    move_away(draft.point);
  }
  if (once_in(2)) draft.point = nudged(draft.point);
  const auto nudge_one = [](Outline& outline) {
    if (outline.flat || !once_in(3)) return;
    Point3& p = outline.points[std::size_t(draw(0, int(outline.points.size()) - 1))];
    p = nudged(p);
  };
  nudge_one(draft.light);
  std::ranges::for_each(draft.blockers, nudge_one);
}

/// What rounding has spoilt is replaced by something plain.
void mend(Draft& draft) {
  Points& light = draft.light.points;
  const bool is_polygon = draft.light_kind == LightKind::polygon || draft.light_kind == LightKind::rounded_polygon;
  if (is_polygon && ConvexPolygon::defect(light)) light = {{0, 0, 4}, {0, 1, 4}, {1, 1, 4}};
  if (draft.light_kind == LightKind::segment && light[0] == light[1]) light[1] = moved(light[0], 1, Point3{1, 0, 0});
  for (std::size_t i = 0; i < draft.blockers.size(); ++i) {
    Points& points = draft.blockers[i].points;
    const bool solid = draft.blocker_kinds[i] == BlockerKind::solid;
    try {
      blocker_of({points}, draft.blocker_kinds[i]);
    } catch (const std::exception&) {
      points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}};
      if (solid) points.push_back({0, 0, 2});
    }
  }
}

VisibilityCase draw_case(Domain domain, const VisibilityMix& mix) {
  const bool bent = domain == Domain::near_degenerate;
  const auto stretch = [&] { return bent && once_in(5) ? std::ldexp(1.0, draw(1, 3) * 10) : 1; };
  Draft draft;
  draft.light_kind = draw_from(mix.lights);
  draft.light = draw_light(draft.light_kind, stretch());
  for (int i = draw(1, mix.most_blockers); i > 0; --i) {
    draft.blocker_kinds.push_back(draw_from(mix.blockers));
    draft.blockers.push_back(draw_blocker(draft.blocker_kinds.back(), stretch()));
    Points& points = draft.blockers.back().points;
    if (once_in(4)) shift(points, 1, moved(draw_from(draft.light.points), -1, draw_from(points)));
  }
  draft.point = draw_point(draft);
  if (bent) bend(draft);
  mend(draft);
  if (draft.light.points.size() > 2 && !once_in(8)) face(draft.light.points, draft.point);
  mend(draft);  // turned round, a polygon at the limit of what counts as rounded may be beyond it
  VisibilityCase result{light_of(draft.light, draft.light_kind, once_in(3)), {}, draft.point};
  for (std::size_t i = 0; i < draft.blockers.size(); ++i) {
    result.blockers.push_back(blocker_of(draft.blockers[i], draft.blocker_kinds[i]));
  }
  return result;
}

}  // namespace

std::string description(const VisibilityCase& drawn) {
  std::ostringstream out;
  out << std::setprecision(17);
  if (const auto* sun = std::get_if<DirectionalLight>(&drawn.light)) {
    write(out, "direction", std::span(&sun->direction, 1));
  } else {
    const auto* area = std::get_if<AreaLight>(&drawn.light);
    write(out, area && area->two_sided ? "two-sided light" : "light", light_points(drawn.light));
  }
  for (const ConvexBlocker& blocker : drawn.blockers) {
    const bool solid = std::holds_alternative<ConvexSolid>(blocker);
    std::visit([&](const auto& shape) { write(out, solid ? "solid" : "polygon", shape.points()); }, blocker);
  }
  write(out, "point", std::span(&drawn.point, 1));
  return out.str();
}

Example example(const VisibilityCase& drawn) {
  return spatial_example(drawn.light, drawn.blockers, {drawn.point});
}

void count_regions(const VisibilityCase& drawn, Census& census) {
  const bool is_pair = drawn.blockers.size() == 1 && pair_refusal(drawn.light, drawn.blockers.front()).empty();
  if (is_pair) census.add(shadow_volumes(drawn.light, drawn.blockers.front()));
  census.add_point(exact_visibility(drawn.light, {drawn.blockers, {}}, drawn.point).region);
}

rc::Gen<VisibilityCase> visibility_cases(Domain domain, const VisibilityMix& mix) {
  return rc::gen::exec([=] { return draw_case(domain, mix); });
}

}  // namespace gnomon::laws
