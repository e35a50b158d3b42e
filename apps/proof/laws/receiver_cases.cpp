#include "apps/proof/laws/receiver_cases.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/pair_generator.h"
#include "apps/proof/laws/point_text.h"
#include "geometry/bodies/polygon_checks.h"
#include "gnomon/visibility.h"

namespace gnomon::laws {
namespace {

using Points = std::vector<Point3>;

Point3 draw_point(int reach, int low, int high) {
  const double x = draw(-reach, reach);
  const double y = draw(-reach, reach);
  return {x, y, double(draw(low, high))};
}

/// A window down to the floor or with one corner on it, which it faces: upright or leaning back.
Points draw_window() {
  const double y = draw(-3, 1), width = draw(1, 3), back = draw(0, 1), high = draw(1, 3);
  const double right = once_in(3) ? draw(1, 2) : 0;
  Points points{{-4, y, 0}, {-4, y + width, right}, {-4 - back, y + width, high + right}, {-4 - back, y, high}};
  if (right != 0 || once_in(2)) points.erase(points.begin() + (right != 0 ? 3 : draw(2, 3)));
  return points;
}

/// A rectangle or a triangle, seen counterclockwise from the side of the floor's middle.
Points draw_light() {
  if (once_in(3)) return draw_window();
  const Point3 p = draw_point(1, 5, 6);
  if (once_in(2)) {
    const double x = draw(1, 3), y = draw(1, 3);
    return {p, {p.x, p.y + y, p.z}, {p.x + x, p.y + y, p.z}, {p.x + x, p.y, p.z}};
  }
  return {p, {p.x + draw(-1, 0), p.y + draw(1, 2), p.z + draw(-1, 0)}, {p.x + draw(1, 2), p.y, p.z + draw(-1, 1)}};
}

Points draw_box(const Point3& p) {
  const double x = draw(1, 2), y = draw(1, 2), z = draw(1, 2);
  Points points;
  for (int c = 0; c < 8; ++c) points.push_back(moved(p, 1, {c & 1 ? x : 0, c & 2 ? y : 0, c & 4 ? z : 0}));
  return points;
}

/// A triangle, a tetrahedron or a box; the lowest of its corners is often on the floor.
Points draw_blocker(Stands stands) {
  const bool on_floor = stands == Stands::on_floor;
  const Point3 p = draw_point(2, -1, on_floor ? 0 : 1);
  const Point3 low{p.x, p.y, std::max(0.0, p.z)};
  const int kind = draw(0, 2);
  if (kind == 2) return draw_box(p);
  Points points{low,
                {low.x + draw(1, 2), low.y + draw(-1, 1), low.z + (on_floor || once_in(2) ? 0 : draw(0, 1))},
                {low.x + draw(-1, 1), low.y + draw(0, 2), low.z + draw(0, 2)}};
  if (kind == 1) points.push_back({low.x + draw(-1, 1), low.y + draw(-1, 1), low.z + draw(1, 2)});
  return points;
}

/// A triangle or a tetrahedron from a vertex of the light, or half way between two, to the floor.
Points draw_fin(const Points& light) {
  const auto vertex = [&] { return light[static_cast<std::size_t>(draw(0, static_cast<int>(light.size()) - 1))]; };
  const Point3 a = vertex(), b = vertex();
  Points points{{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}};
  for (int n = draw(2, 3); n > 0; --n) points.push_back({double(draw(-2, 2)), double(draw(-2, 2)), 0});
  return points;
}

ConvexBlocker blocker_of(Points points) {
  if (points.size() > 3 && !are_coplanar(points)) return ConvexSolid::hull_of(points);
  points.resize(3);
  if (ConvexPolygon::defect(points)) points = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  return ConvexPolygon::from_points(points);
}

void bend(Points& points, int kind, double scale) {
  for (Point3& p : points) {
    if (kind == 1) p = {scale * p.x, p.y, p.z};
    if (kind == 2) p = moved({1e8, -1e8, 1e8}, 0x1p-20, p);
  }
}

ReceiverCase draw_scene(Domain domain, int most_blockers, Stands stands) {
  const bool bent = domain == Domain::near_degenerate;
  const int kind = bent ? draw(0, 2) : 0;
  const double scale = std::ldexp(1.0, draw(-1, 1) * 8);
  Points light = draw_light();
  const Points straight = light;
  Points floor{{-7, -7, 0}, {7, -7, 0}, {7, 7, 0}, {-7, 7, 0}};
  if (once_in(3)) floor = {{-9, -7, 0}, {8, -6, 0}, {0, 9, 0}};
  bend(light, kind, scale);
  bend(floor, kind, scale);
  if (bent && light.size() == 3 && once_in(2)) light[2] = nudged_beside_whole_numbers(light[2]);
  std::vector<ConvexBlocker> blockers;
  for (int i = once_in(3) ? draw(1, most_blockers) : 1; i > 0; --i) {
    Points points = once_in(5) ? draw_fin(straight) : draw_blocker(stands);
    bend(points, kind, scale);
    if (bent && points.size() < 5 && once_in(2)) points[1] = nudged_beside_whole_numbers(points[1]);
    blockers.push_back(blocker_of(points));
  }
  if (ConvexPolygon::defect(light) || !ConvexPolygon::from_points(light).is_flat()) {
    light = {{0, 0, 6}, {0, 1, 6}, {1, 0, 6}};
    bend(light, kind, scale);
  }
  Point3 direction{double(draw(-3, 3)), double(draw(-3, 3)), 0};
  if (direction == Point3{}) direction.x = 1;
  const auto choice = static_cast<std::uint32_t>(draw(0, 9999));
  return {AreaLight{ConvexPolygon::from_points(light)},
          blockers,
          ConvexPolygon::from_points(floor),
          choice,
          draw(1, 7) / 8.0,
          direction};
}

}  // namespace

std::string description(const ReceiverCase& drawn) {
  std::ostringstream out;
  out << std::setprecision(17);
  write(out, "light", light_points(drawn.light));
  for (const ConvexBlocker& blocker : drawn.blockers) {
    const bool solid = std::holds_alternative<ConvexSolid>(blocker);
    std::visit([&](const auto& shape) { write(out, solid ? "solid" : "polygon", shape.points()); }, blocker);
  }
  write(out, "floor", drawn.floor.points());
  write(out, "direction", std::span(&drawn.direction, 1));
  out << "choice " << drawn.choice << ", share " << drawn.share << "\n";
  return out.str();
}

Example example(const ReceiverCase& drawn) {
  Example result = spatial_example(drawn.light, drawn.blockers, {drawn.floor.points()[0]});
  std::get<SpaceScene>(result.scene).receivers.push_back({"floor", drawn.floor});
  return result;
}

void count_regions(const ReceiverCase& drawn, Census& census) {
  const auto corners = drawn.floor.points();
  const Point3 p = moved(corners[0], 0.5, moved(corners[2], -1, corners[0]));
  census.add_point(exact_visibility(drawn.light, {drawn.blockers, {}}, p).region);
}

rc::Gen<ReceiverCase> receiver_cases(Domain domain, int most_blockers, Stands stands) {
  return rc::gen::exec([=] { return draw_scene(domain, most_blockers, stands); });
}

}  // namespace gnomon::laws
