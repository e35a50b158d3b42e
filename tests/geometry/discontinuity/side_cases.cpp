#include "tests/geometry/discontinuity/side_cases.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <utility>

#include "geometry/bodies/polygon_checks.h"
#include "geometry/numbers/orientation.h"

namespace gnomon::test_support {
namespace {

using Points = std::vector<Point3>;

double half(Dice& dice, int least, int most) {
  return dice.draw(2 * least, 2 * most) / 2.0;
}

/// One of some heights, as often as it is told.
double height(Dice& dice, std::initializer_list<double> heights) {
  return dice.one_of(std::vector<double>(heights));
}

Points box_points(const Point3& low, const Point3& size) {
  Points points;
  for (int c = 0; c < 8; ++c) {
    points.push_back({low.x + (c & 1 ? size.x : 0), low.y + (c & 2 ? size.y : 0), low.z + (c & 4 ? size.z : 0)});
  }
  return points;
}

std::optional<ConvexPolygon> polygon_of(const Points& points) {
  if (ConvexPolygon::defect(points)) return std::nullopt;
  ConvexPolygon polygon = ConvexPolygon::from_points(points);
  return polygon.is_flat() ? std::optional(std::move(polygon)) : std::nullopt;
}

/// Polygons in the order given, solids as hulls.
std::optional<ConvexBlocker> blocker_of(const Points& points) {
  if (auto polygon = polygon_of(points)) return ConvexBlocker(*std::move(polygon));
  if (points.size() < 4 || are_coplanar(points)) return std::nullopt;
  return ConvexBlocker(ConvexSolid::hull_of(points));
}

/// Upright, or leaning by `lean`, on the level segment from a to b.
Points wall_on(const Point3& a, const Point3& b, double rise, const Point3& lean) {
  return {a, b, {b.x + lean.x, b.y + lean.y, b.z + rise}, {a.x + lean.x, a.y + lean.y, a.z + rise}};
}

std::optional<Light> window(Dice& dice) {
  const double y = dice.draw(-2, 1), z = height(dice, {-1, 0, 0, 0, 0.5, 1}), rise = dice.draw(1, 2);
  const double lean = dice.once_in(2) ? 0 : dice.draw(-1, 1);
  Points points = wall_on({-4, y, z}, {-4, y + dice.draw(1, 3), z}, rise, {lean, 0, 0});
  if (dice.once_in(3)) points.erase(points.begin() + dice.draw(0, 3));
  if (dice.once_in(4)) points[0].z = z - height(dice, {0.5, 1});
  if (dice.once_in(3)) std::reverse(points.begin(), points.end());
  auto polygon = polygon_of(points);
  if (!polygon) return std::nullopt;
  return AreaLight{*std::move(polygon), dice.once_in(3)};
}

std::optional<Light> lamp_above(Dice& dice) {
  const double x = dice.draw(-3, 1), y = dice.draw(-2, 1), z = height(dice, {0, 1, 3, 3, 4});
  Points points{{x, y, z}, {x, y + dice.draw(1, 2), z}, {x + dice.draw(1, 2), y + 1, z}};
  if (dice.once_in(2)) points = {{x, y, z}, {x, y + 1, z}, {x + 2, y + 1, z}, {x + 2, y, z}};
  auto polygon = polygon_of(points);
  if (!polygon) return std::nullopt;
  return AreaLight{*std::move(polygon), dice.once_in(4)};
}

std::optional<Light> tube(Dice& dice) {
  const Point3 start{-4.0 + dice.draw(0, 2), double(dice.draw(-2, 1)), height(dice, {-1, 0, 0, 0.5, 1, 2})};
  Point3 end{start.x + (dice.once_in(2) ? 0 : dice.draw(-1, 2)), start.y + dice.draw(0, 3), start.z};
  if (dice.once_in(2)) end.z = height(dice, {0, 1, 2, 3});
  if (start == end) return std::nullopt;
  return LinearLight{start, end};
}

std::optional<Light> room_light(Dice& dice) {
  const int kind = dice.draw(0, 9);
  if (kind < 4) return window(dice);
  if (kind < 7) return tube(dice);
  if (kind == 7) return lamp_above(dice);
  if (kind == 8) return PointLight{{-4, half(dice, -2, 2), height(dice, {0, 1, 2})}};
  return DirectionalLight{{double(dice.draw(0, 2)), double(dice.draw(-1, 1)), height(dice, {-2, -1, -1})}};
}

/// Low, so that high walls hide all of it: a window on the floor, or a tube that is level or stands on the floor.
std::optional<Light> light_behind_gap(Dice& dice) {
  const double y = dice.draw(-2, 0), width = dice.draw(1, 2);
  if (dice.once_in(3)) {
    const double z = height(dice, {0, 0.5, 1});
    return LinearLight{{-4, y, z}, {-4.0 + dice.draw(-1, 1), y + width, z == 0 ? 1 : z}};
  }
  Points points = wall_on({-4, y, 0}, {-4, y + width, 0}, height(dice, {0.5, 1}), {-half(dice, 0, 1), 0, 0});
  points[2].y += half(dice, -1, 0);
  auto polygon = polygon_of(points);
  if (!polygon) return std::nullopt;
  return AreaLight{*std::move(polygon), dice.once_in(4)};
}

Points wall_points(Dice& dice) {
  const double z = height(dice, {-1, 0, 0, 0, 0, 0.5});
  const Point3 a{half(dice, -2, 2), half(dice, -2, 2), z};
  const Point3 b{a.x + dice.draw(-1, 1), a.y + dice.draw(-2, 2), z};
  const Point3 lean{dice.once_in(4) ? 1.0 : 0.0, 0, 0};
  return wall_on(a, b, height(dice, {0.5, 1, 1, 2}), lean);
}

Points board_points(Dice& dice) {
  const Point3 p{half(dice, -2, 2), half(dice, -2, 2), height(dice, {0, 0, 0.5, 1, 1})};
  const double x = dice.draw(1, 2), y = dice.draw(1, 2), tilt = dice.once_in(3) ? dice.draw(-1, 1) : 0;
  return {p, {p.x + x, p.y, p.z + tilt}, {p.x + x, p.y + y, p.z + tilt}, {p.x, p.y + y, p.z}};
}

/// Few points, some of them on the floor.
Points corner_points(Dice& dice) {
  Points points;
  for (int n = dice.draw(3, 5); n > 0; --n) {
    points.push_back({half(dice, -1, 2), half(dice, -2, 2), height(dice, {-1, 0, 0, 0, 1, 1, 2})});
  }
  return points;
}

Points room_blocker(Dice& dice) {
  switch (dice.draw(0, 4)) {
    case 0:
    case 1: {
      const Point3 low{half(dice, -2, 2), half(dice, -2, 1), height(dice, {-1, 0, 0, 0, 0.5})};
      return box_points(low, {height(dice, {0.5, 1, 2}), height(dice, {0.5, 1, 2}), height(dice, {0.5, 1, 1, 2})});
    }
    case 2:
      return wall_points(dice);
    case 3:
      return board_points(dice);
    default:
      return corner_points(dice);
  }
}

/// Two walls across the room that leave a gap, seen from some places only; its sides are upright or lean to each other.
/// At times a third wall runs through the light.
void add_gap(Dice& dice, SideCase& drawn) {
  const double x = half(dice, -1, 0), z = height(dice, {-1, 0, 0, 0, 0.5}), rise = dice.draw(2, 4);
  const Point3 lean{dice.once_in(3) ? 1.0 : 0.0, 0, 0};
  const auto add = [&](Points wall, double skew) {
    wall[2].y += skew;
    if (auto blocker = blocker_of(wall)) drawn.blockers.push_back(*std::move(blocker));
  };
  add(wall_on({x, -6, z}, {x, half(dice, -1, 1), z}, rise, lean), half(dice, -1, 1));
  const double back = x + height(dice, {0, 0.5, 1, 2});
  add(wall_on({back, 6, z}, {back, half(dice, -1, 1), z}, rise, {}), half(dice, -1, 1));
  if (!dice.once_in(3)) return;
  const double y = half(dice, -1, 1);
  add(wall_on({-6, y, z}, {x, y, z}, rise, {}), 0);
}

Points reversed(Points points) {
  std::reverse(points.begin(), points.end());
  return points;
}

/// A facet of a blocker, facing out or in; of a flat one either side.
ConvexPolygon facet_of(Dice& dice, const ConvexBlocker& blocker) {
  Points loop;
  if (const auto* solid = std::get_if<ConvexSolid>(&blocker)) {
    for (const std::uint32_t k : dice.one_of(solid->facets()).loop) loop.push_back(solid->points()[k]);
  } else {
    const auto points = std::get<ConvexPolygon>(blocker).points();
    loop.assign(points.begin(), points.end());
  }
  return ConvexPolygon::from_points(dice.once_in(3) ? reversed(loop) : loop);
}

Points points_of(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light)) return {point->position};
  if (const auto* linear = std::get_if<LinearLight>(&light)) return {linear->start, linear->end};
  const auto* area = std::get_if<AreaLight>(&light);
  if (!area) return {};
  return {area->polygon.points().begin(), area->polygon.points().end()};
}

Points points_of(const ConvexBlocker& blocker) {
  return std::visit([](const auto& s) { return Points(s.points().begin(), s.points().end()); }, blocker);
}

/// All points of the light and the blockers.
Points all_points(const SideCase& drawn) {
  Points points = points_of(drawn.light);
  for (const ConvexBlocker& blocker : drawn.blockers) {
    const Points more = points_of(blocker);
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

/// An upright wall, in the plane of a point of the scene.
ConvexPolygon wall_receiver(Dice& dice, const SideCase& drawn) {
  const Points points = all_points(drawn);
  const Point3 p = dice.one_of(points);
  Points wall = dice.once_in(2) ? Points{{p.x, -5, -1}, {p.x, 5, -1}, {p.x, 5, 4}, {p.x, -5, 4}}
                                : Points{{-6, p.y, -1}, {6, p.y, -1}, {6, p.y, 4}, {-6, p.y, 4}};
  return ConvexPolygon::from_points(dice.once_in(2) ? reversed(wall) : wall);
}

/// A large triangle in the plane of three points of the scene.
std::optional<ConvexPolygon> receiver_through(Dice& dice, const SideCase& drawn) {
  const Points points = all_points(drawn);
  std::array<Point3, 3> p{};
  for (Point3& q : p) q = dice.one_of(points);
  Points large;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 &a = p[k], &b = p[(k + 1) % 3], &c = p[(k + 2) % 3];
    large.push_back({3 * a.x - b.x - c.x, 3 * a.y - b.y - c.y, 3 * a.z - b.z - c.z});
  }
  return polygon_of(large);
}

/// Mostly turned so that some of the light lies before it.
ConvexPolygon turned(Dice& dice, const SideCase& drawn, const ConvexPolygon& receiver) {
  const Points points(receiver.points().begin(), receiver.points().end());
  const auto rises = [&](const Point3& l) { return exact_orientation(points[0], points[1], points[2], l) > 0; };
  const Points light = points_of(drawn.light);
  if (dice.once_in(6) || light.empty() || std::any_of(light.begin(), light.end(), rises)) return receiver;
  return ConvexPolygon::from_points(reversed(points));
}

template <class Draw>
void add_blockers(Dice& dice, SideCase& drawn, int most, const Draw& draw) {
  for (int n = dice.draw(1, most); n > 0 || drawn.blockers.empty(); --n) {
    if (auto blocker = blocker_of(draw(dice))) drawn.blockers.push_back(*std::move(blocker));
  }
}

Point3 small_point(Dice& dice) {
  return {double(dice.draw(-1, 2)), double(dice.draw(-1, 2)), double(dice.draw(-1, 2))};
}

Points tangle_points(Dice& dice) {
  if (dice.once_in(4)) return box_points(small_point(dice), {1, double(dice.draw(1, 2)), 1});
  Points points;
  for (int n = dice.draw(3, 5); n > 0; --n) points.push_back(small_point(dice));
  return points;
}

std::optional<Light> tangle_light(Dice& dice) {
  const auto far = [&] {
    Point3 p = small_point(dice);
    p.x -= 3;
    return p;
  };
  const int kind = dice.draw(0, 5);
  if (kind == 0) return PointLight{far()};
  if (kind < 3) {
    const Point3 a = far(), b = far();
    return a == b ? std::nullopt : std::optional<Light>(LinearLight{a, b});
  }
  Points points{far(), far(), far()};
  if (dice.once_in(2)) {
    const auto &a = points[0], &b = points[1], &c = points[2];
    points.push_back({a.x + c.x - b.x, a.y + c.y - b.y, a.z + c.z - b.z});
  }
  auto polygon = polygon_of(points);
  if (!polygon) return std::nullopt;
  return AreaLight{*std::move(polygon), dice.once_in(2)};
}

/// A window that stands on the floor or hangs above it, a tube or a lamp; of few digits, often symmetric.
std::optional<Light> touched_light(Dice& dice) {
  const double z = height(dice, {0, 0, 1, 2}), rise = dice.draw(1, 2), y = dice.draw(1, 2);
  if (dice.once_in(5)) return LinearLight{{-1, 0, z}, {dice.once_in(2) ? 1.0 : -1.0, 0, z + 1}};
  Points points{{0, -y, z}, {0, y, z}, {0, y, z + rise}, {0, -y, z + rise}};
  if (dice.once_in(3)) points = {{0, -y, z}, {0, y, z}, {0, half(dice, -1, 1), z + rise}};
  if (dice.once_in(4)) points = {{0, 0, 2}, {0, y, 2}, {half(dice, 1, 2), half(dice, 0, 1), 2 + half(dice, 0, 1)}};
  if (dice.once_in(2)) std::reverse(points.begin(), points.end());
  auto polygon = polygon_of(points);
  if (!polygon) return std::nullopt;
  return AreaLight{*std::move(polygon), dice.once_in(2)};
}

/// One of some points, or half way between two.
Point3 point_among(Dice& dice, const Points& points) {
  const Point3 a = dice.one_of(points), b = dice.once_in(2) ? a : dice.one_of(points);
  return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
}

/// At vertices of the light, on its edges or inside; at, on or in earlier blockers; on the floor; through the light.
Points touching_points(Dice& dice, const SideCase& drawn) {
  const Points light = points_of(drawn.light), all = all_points(drawn);
  Points points{point_among(dice, dice.once_in(3) ? all : light)};
  if (dice.once_in(3)) {
    // An edge from the floor through the place.
    const Point3 w = points[0], foot{half(dice, -1, 3), half(dice, -1, 1), 0};
    points = {foot, {2 * w.x - foot.x, 2 * w.y - foot.y, 2 * w.z}};
  }
  for (int n = dice.draw(2, 3); n > 0; --n) {
    const int kind = dice.draw(0, 9);
    if (kind < 2) points.push_back(point_among(dice, light));
    if (kind == 2) points.push_back(point_among(dice, all));
    if (kind == 3 || kind == 4) points.push_back({half(dice, -1, 3), half(dice, -2, 2), height(dice, {0.5, 1, 2, 3})});
    if (kind > 4) points.push_back({half(dice, -1, 3), half(dice, -1, 1), 0});
  }
  return points;
}

/// Draws until there is something.
template <class Draw>
auto drawn_from(Dice& dice, const Draw& draw) {
  auto made = draw(dice);
  while (!made) made = draw(dice);
  return *std::move(made);
}

void write_points(std::ostringstream& out, const Points& points) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    out << (k ? "," : "") << "[" << points[k].x << "," << points[k].y << "," << points[k].z << "]";
  }
}

void write_light(std::ostringstream& out, const Light& light) {
  if (const auto* parallel = std::get_if<DirectionalLight>(&light)) {
    const Point3& d = parallel->direction;
    out << R"("shape":"direction","direction":[)" << d.x << "," << d.y << "," << d.z << "]";
  } else if (const auto* point = std::get_if<PointLight>(&light)) {
    out << R"("shape":"point","position":)";
    write_points(out, {point->position});
  } else {
    const auto* area = std::get_if<AreaLight>(&light);
    out << R"("shape":")" << (area ? "polygon" : "segment") << "\"";
    if (area && area->two_sided) out << R"(,"two_sided":true)";
    out << R"(,"vertices":[)";
    write_points(out, points_of(light));
    out << "]";
  }
}

}  // namespace

SideCase room(Dice& dice) {
  const bool has_gap = dice.once_in(3);
  SideCase drawn{drawn_from(dice, has_gap ? light_behind_gap : room_light), {}, {}};
  if (has_gap) add_gap(dice, drawn);
  if (!has_gap || dice.once_in(4)) add_blockers(dice, drawn, has_gap ? 1 : 3, room_blocker);
  const Points floor{{-6, -5, 0}, {6, -5, 0}, {6, 5, 0}, {-6, 5, 0}};
  drawn.receivers.push_back(ConvexPolygon::from_points(dice.once_in(6) ? reversed(floor) : floor));
  const ConvexPolygon other =
      dice.once_in(2) ? wall_receiver(dice, drawn) : facet_of(dice, dice.one_of(drawn.blockers));
  drawn.receivers.push_back(turned(dice, drawn, other));
  return drawn;
}

SideCase tangle(Dice& dice) {
  SideCase drawn{drawn_from(dice, tangle_light), {}, {}};
  add_blockers(dice, drawn, 3, tangle_points);
  const ConvexPolygon through = drawn_from(dice, [&](Dice& d) { return receiver_through(d, drawn); });
  for (const ConvexPolygon& r : {through, facet_of(dice, dice.one_of(drawn.blockers))}) {
    drawn.receivers.push_back(turned(dice, drawn, r));
  }
  return drawn;
}

SideCase luminaire(Dice& dice) {
  SideCase drawn{drawn_from(dice, touched_light), {}, {}};
  const bool is_upright = dice.once_in(3);
  add_blockers(dice, drawn, 3, [&](Dice& d) {
    Points points = touching_points(d, drawn);
    // In one upright plane, often that in the middle of all, or at a side of the light.
    const double y = d.one_of(points_of(drawn.light)).y;
    for (Point3& p : points) p.y = is_upright ? (d.once_in(4) ? p.y : y == p.y ? y : 0) : p.y;
    return points;
  });
  drawn.receivers.push_back(ConvexPolygon::from_points({{-6, -5, 0}, {6, -5, 0}, {6, 5, 0}, {-6, 5, 0}}));
  drawn.receivers.push_back(turned(dice, drawn, wall_receiver(dice, drawn)));
  return drawn;
}

std::string scene_text(const SideCase& drawn) {
  std::ostringstream out;
  out << R"({"gnomon":1,"dimension":3,"lights":[{"name":"l",)";
  write_light(out, drawn.light);
  out << R"(}],"blockers":[)";
  for (std::size_t k = 0; k < drawn.blockers.size(); ++k) {
    const bool is_solid = std::holds_alternative<ConvexSolid>(drawn.blockers[k]);
    out << (k ? "," : "") << R"({"name":"b)" << k << R"(","shape":")" << (is_solid ? "polytope" : "polygon")
        << R"(","vertices":[)";
    write_points(out, points_of(drawn.blockers[k]));
    out << "]}";
  }
  out << R"(],"receivers":[)";
  for (std::size_t k = 0; k < drawn.receivers.size(); ++k) {
    const auto points = drawn.receivers[k].points();
    out << (k ? "," : "") << R"({"name":"r)" << k << R"(","shape":"polygon","vertices":[)";
    write_points(out, {points.begin(), points.end()});
    out << "]}";
  }
  out << "]}";
  return out.str();
}

}  // namespace gnomon::test_support
