#include "apps/proof/laws/any_pair.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/pair_generator.h"
#include "geometry/bodies/polygon_checks.h"
#include "gnomon/pair.h"
#include "gnomon/shadow_volume.h"
#include "gnomon/visibility.h"

namespace gnomon::laws {
namespace {

using Points = std::vector<Point3>;

const Point3& draw_one(const Points& points) {
  return points[std::size_t(draw(0, int(points.size()) - 1))];
}

/// What is done to all points of a pair, or to the light or the blocker alone.
struct Bend {
  double scale = 1;
  Point3 offset{};
  int nudges = 0;

  Points operator()(Points points) const {
    for (Point3& p : points) p = moved(offset, scale, p);
    return points;
  }
};

Bend draw_bend(Domain domain) {
  Bend bend;
  if (domain == Domain::random) return bend;
  const double size = std::ldexp(1.0, draw(0, 3) * 9);
  if (once_in(3)) bend.scale = once_in(2) ? size : 1 / size;
  if (once_in(3)) bend.offset = moved({}, size, draw_vector(2));
  bend.nudges = draw(0, 2);
  return bend;
}

Points with_nudges(Points points, int nudges) {
  for (; nudges > 0; --nudges) {
    Point3& p = points[std::size_t(draw(0, int(points.size()) - 1))];
    p = nudged(p);
  }
  return points;
}

bool is_polygon(const Points& points) {
  return !ConvexPolygon::defect(points);
}

/// A flat polygon; nudges that leave it no polygon, or not flat, are left out.
ConvexPolygon draw_flat(const Bend& bend) {
  const Points points = draw_flat_points(once_in(8) ? 64 : 1);
  const Points bent = with_nudges(bend(points), bend.nudges);
  for (const Points& candidate : {bent, bend(points), points}) {
    if (!is_polygon(candidate)) continue;
    ConvexPolygon polygon = ConvexPolygon::from_points(candidate);
    if (polygon.is_flat()) return polygon;
  }
  return ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

/// A polygon whose vertices were rounded off their plane, as decimal coordinates are.
ConvexPolygon draw_rounded(const Bend& bend) {
  const double scales[] = {0.1, 0.3, 0.7, 1.1};
  const double scale = scales[draw(0, 3)];
  const Points points = bend(draw_flat_points(1));
  Points rounded;
  for (const Point3& p : points) rounded.push_back({p.x * scale, p.y * scale + 0.1, p.z * scale});
  for (const Points& candidate : {rounded, with_nudges(points, 3)}) {
    if (is_polygon(candidate) && !ConvexPolygon::from_points(candidate).is_flat()) {
      return ConvexPolygon::from_points(candidate);
    }
  }
  return ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0x1p-53}, {0, 1, 0}});
}

Points draw_solid_points() {
  if (once_in(4)) {  // a box
    const Point3 o = draw_vector(2);
    const double x = draw(1, 3), y = draw(1, 3), z = draw(1, 3);
    Points points;
    for (int c = 0; c < 8; ++c) points.push_back(moved(o, 1, {c & 1 ? x : 0, c & 2 ? y : 0, c & 4 ? z : 0}));
    return points;
  }
  Points points;
  for (int left = draw(4, 8); left > 0; --left) points.push_back(draw_vector(3));
  return points;
}

ConvexSolid draw_solid(const Bend& bend) {
  const Points points = draw_solid_points();
  const Points bent = with_nudges(bend(points), bend.nudges);
  for (const Points& candidate : {bent, points}) {
    if (!are_coplanar(candidate)) return ConvexSolid::hull_of(candidate);
  }
  return ConvexSolid::hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
}

Light draw_light(PairLightKind kind, const Bend& bend) {
  switch (kind) {
    case PairLightKind::point:
      return PointLight{with_nudges(bend({draw_vector(4)}), bend.nudges)[0]};
    case PairLightKind::direction: {
      const Point3 direction = draw_vector(3);
      return DirectionalLight{direction == Point3{} ? Point3{0, 0, -1} : direction};
    }
    case PairLightKind::segment: {
      const Points ends = with_nudges(bend({draw_vector(4), draw_vector(4)}), bend.nudges);
      return ends[0] == ends[1] ? LinearLight{ends[0], moved(ends[0], 1, {1, 0, 0})} : LinearLight{ends[0], ends[1]};
    }
    case PairLightKind::rounded_polygon:
      return AreaLight{draw_rounded(bend), once_in(2)};
    default:
      return AreaLight{draw_flat(bend), kind == PairLightKind::two_sided_polygon};
  }
}

ConvexBlocker draw_blocker(PairBlockerKind kind, const Bend& bend) {
  if (kind == PairBlockerKind::solid) return draw_solid(bend);
  if (kind == PairBlockerKind::rounded_polygon) return convex_blocker(draw_rounded(bend));
  return draw_flat(bend);
}

Points points_of(const Light& light) {
  if (const auto* direction = std::get_if<DirectionalLight>(&light)) return {moved({}, -8, direction->direction)};
  return light_points(light);
}

Points points_of(const ConvexBlocker& blocker) {
  const auto points = std::visit([](const auto& shape) { return shape.points(); }, blocker);
  return {points.begin(), points.end()};
}

Point3 draw_point(Domain domain, const Points& light, const Points& blocker) {
  const double steps[] = {2, 1.5, 3, 1.25, 9, 1, 0.5, 0, -1};
  const Point3 l = once_in(2) ? draw_one(light) : between(draw_one(light), 0.25 * draw(0, 4), draw_one(light));
  const Point3 b = once_in(2) ? draw_one(blocker) : between(draw_one(blocker), 0.25 * draw(0, 4), draw_one(blocker));
  Point3 p;
  switch (draw(0, 5)) {
    case 0:
      p = moved(draw_one(once_in(2) ? light : blocker), 1, draw_vector(6));
      break;
    case 1:  // on a plane through an edge (or a diagonal) of the blocker
      p = between(between(draw_one(blocker), 0.5 * draw(-1, 3), draw_one(blocker)), 0.5 * draw(-2, 6), l);
      break;
    default:
      p = between(l, steps[draw(0, 8)], b);
      break;
  }
  return domain == Domain::near_degenerate && once_in(2) ? nudged(p) : p;
}

}  // namespace

std::string description(const AnyPair& pair) {
  std::ostringstream out;
  out << std::setprecision(17);
  const auto write = [&](const char* what, const Points& points) {
    out << what << ":";
    for (const Point3& p : points) out << " {" << p.x << ", " << p.y << ", " << p.z << "}";
    out << "\n";
  };
  const auto* area = std::get_if<AreaLight>(&pair.light);
  if (const auto* direction = std::get_if<DirectionalLight>(&pair.light)) {
    write("direction", {direction->direction});
  } else {
    write(area && area->two_sided ? "two-sided light" : "light", light_points(pair.light));
  }
  write(std::holds_alternative<ConvexSolid>(pair.blocker) ? "solid" : "blocker", points_of(pair.blocker));
  write("points", pair.points);
  return out.str();
}

Example example(const AnyPair& pair) {
  return spatial_example(pair.light, std::span(&pair.blocker, 1), pair.points);
}

void count_regions(const AnyPair& pair, Census& census) {
  if (pair_refusal(pair.light, pair.blocker).empty()) census.add(shadow_volumes(pair.light, pair.blocker));
  if (pair.points.empty()) return;
  census.add_point(exact_visibility(pair.light, {{pair.blocker}, {}}, pair.points.front()).region);
}

AnyPair draw_any_pair(Domain domain, PairLightKind light_kind, PairBlockerKind blocker_kind, int points) {
  const Bend common = draw_bend(domain);
  const Bend of_light = once_in(3) ? draw_bend(domain) : common;
  AnyPair pair{draw_light(light_kind, of_light), draw_blocker(blocker_kind, common), {}};
  for (double distance = 1; !pair_refusal(pair.light, pair.blocker).empty(); distance *= 2) {
    Points vertices = light_points(pair.light);
    for (Point3& p : vertices) p = moved(p, distance, {1, 2, 5});
    const bool is_polygon_still = is_polygon(vertices);
    pair.light = AreaLight{is_polygon_still ? ConvexPolygon::from_points(vertices) : draw_flat(of_light), true};
  }
  const Points light = points_of(pair.light);
  const Points blocker = points_of(pair.blocker);
  for (; points > 0; --points) pair.points.push_back(draw_point(domain, light, blocker));
  return pair;
}

}  // namespace gnomon::laws
