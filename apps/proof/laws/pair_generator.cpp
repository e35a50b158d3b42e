#include "apps/proof/laws/pair_generator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "apps/proof/laws/definition.h"
#include "apps/proof/laws/draw.h"

namespace gnomon::laws {
namespace {

using Points = std::vector<Point3>;
using Outline = std::vector<Point2>;

Point3 draw_vector(int reach) {
  const int x = draw(-reach, reach);
  const int y = draw(-reach, reach);
  return Point3{double(x), double(y), double(draw(-reach, reach))};
}

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Appends the lower hull of the points, in their order, to the outline; the last point is left to the next chain.
void append_chain(const Outline& points, bool keep_collinear, Outline& outline) {
  const std::size_t begin = outline.size();
  for (const Point2& p : points) {
    while (outline.size() >= begin + 2) {
      const double bend = turn(outline[outline.size() - 2], outline.back(), p);
      if (keep_collinear ? bend >= 0 : bend > 0) break;
      outline.pop_back();
    }
    outline.push_back(p);
  }
  outline.pop_back();
}

/// A convex outline with small coordinates, integers or halves, counterclockwise; collinear vertices are kept now and
/// then.
Outline draw_outline() {
  if (once_in(3)) {
    const double width = draw(1, 3);
    const double height = draw(1, 3);
    Outline rectangle = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    if (once_in(3)) rectangle.insert(rectangle.begin() + 1, {width / 2, 0});
    if (once_in(3)) rectangle.push_back({0, height / 2});
    return rectangle;
  }
  Outline points;
  for (int left = draw(3, 8); left > 0; --left) {
    const int x = draw(-3, 3);
    points.push_back({double(x), double(draw(-3, 3))});
  }
  const auto before = [](const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::ranges::sort(points, before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto bends = [&](const Point2& p) { return turn(points.front(), points.back(), p) != 0; };
  if (!std::ranges::any_of(points, bends)) return {{0, 0}, {1, 0}, {0, 1}};
  const bool keep_collinear = !once_in(2);
  Outline outline;
  append_chain(points, keep_collinear, outline);
  std::ranges::reverse(points);
  append_chain(points, keep_collinear, outline);
  return outline;
}

bool parallel(const Point3& u, const Point3& v) {
  return u.y * v.z == u.z * v.y && u.z * v.x == u.x * v.z && u.x * v.y == u.y * v.x;
}

/// A convex polygon, flat because it is a combination of two integer vectors that needs no rounding; a needle stretches
/// the first.
Points draw_polygon(double stretch) {
  const Outline outline = draw_outline();
  const Point3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  const int axis = draw(0, 5);
  Point3 u = axes[axis % 3];
  Point3 v = axes[axis % 3 + 1];
  if (axis >= 3) {
    const Point3 tilted_u = draw_vector(2);
    const Point3 tilted_v = draw_vector(2);
    if (!parallel(tilted_u, tilted_v)) u = tilted_u, v = tilted_v;
  }
  const Point3 origin = draw_vector(3);
  Points points;
  for (const Point2& p : outline) points.push_back(moved(moved(origin, stretch * p.x, u), p.y, v));
  std::rotate(points.begin(), points.begin() + draw(0, int(points.size()) - 1), points.end());
  if (once_in(2)) std::ranges::reverse(points);
  return points;
}

std::optional<ConvexPolygon> flat_polygon(const Points& points) {
  if (points.size() < 3 || ConvexPolygon::defect(points)) return std::nullopt;
  ConvexPolygon polygon = ConvexPolygon::from_points(points);
  return polygon.is_flat() ? std::optional(polygon) : std::nullopt;
}

/// The light as a list of vertices, which are easier to move about.
struct Emitter {
  Points points;
  bool two_sided = false;
};

/// The light, and for a polygon that winds the wrong way the one that shows its front.
std::optional<Light> standing_apart(const Emitter& emitter, const ConvexPolygon& blocker) {
  const Points& p = emitter.points;
  std::vector<Light> candidates;
  if (p.size() == 1) candidates = {PointLight{p[0]}};
  if (p.size() == 2) candidates = {LinearLight{p[0], p[1]}};
  if (const auto polygon = flat_polygon(p)) {
    candidates = {AreaLight{*polygon, emitter.two_sided},
                  AreaLight{ConvexPolygon::from_points({p.rbegin(), p.rend()}), emitter.two_sided}};
  }
  for (const Light& light : candidates) {
    if (stands_apart(light, blocker)) return light;
  }
  return std::nullopt;
}

/// A linear light on a line that is meant to have something to do with the blocker.
Points draw_segment(const Points& blocker) {
  const std::size_t i = std::size_t(draw(0, int(blocker.size()) - 1));
  const Point3& a = blocker[i];
  const Point3& b = blocker[(i + 1) % blocker.size()];
  const Point3& c = blocker[(i + 2) % blocker.size()];
  const Point3 edge = moved(b, -1, a);
  const Point3 away = draw_vector(3);
  switch (draw(0, 4)) {
    case 0:  // anywhere
      return {away, moved(away, 1, draw_vector(3))};
    case 1:  // its line through the line of an edge, at a corner, inside the edge or beyond
      return {moved(moved(a, 0.5 * draw(-1, 3), edge), 1, away), moved(moved(a, 0.5 * draw(-1, 3), edge), 3, away)};
    case 2: {  // its line through one point of the edge's line
      const Point3 foot = moved(a, 0.5 * draw(-1, 3), edge);
      return {moved(foot, 1, away), moved(foot, 3, away)};
    }
    case 3: {  // its line through the blocker, if that is no degenerate triangle
      const Point3 foot = moved(moved(a, 0.25, edge), 0.25, moved(c, -1, a));
      return {moved(foot, 1, away), moved(foot, 2, away)};
    }
    default: {  // parallel to an edge
      const Point3 start = moved(a, 1, away);
      return {start, moved(start, draw(1, 2), edge)};
    }
  }
}

Emitter draw_emitter(Lights lights, const Points& blocker, double stretch) {
  const int kind = lights == Lights::points ? 0 : draw(lights == Lights::with_extent ? 1 : 0, 4);
  if (kind == 0) return {{draw_vector(4)}};
  if (kind <= 2) {
    Points ends = draw_segment(blocker);
    if (ends[0] == ends[1]) ends[1] = moved(ends[0], 1, Point3{1, 0, 0});
    return {ends};
  }
  Points points = draw_polygon(stretch);
  return {points, once_in(3)};
}

/// The light moved along a direction, farther and farther, until it stands apart. It does in the end unless the
/// direction runs along the plane of light or blocker. The last one does not: both normals have the direction of an
/// integer vector with entries from -8 to 8, and 1, 17, 289 add up to zero with no such weights but zeros.
Light placed(const Emitter& emitter, const ConvexPolygon& blocker) {
  const Point3 drawn = draw_vector(2);
  const int start = draw(0, 2);
  for (const Point3& direction : {drawn, Point3{1, 2, 5}, Point3{1, 17, 289}}) {
    for (int exponent = -1; exponent < 40; ++exponent) {
      Emitter there = emitter;
      const double distance = exponent < 0 ? start : std::ldexp(1.0, exponent);
      for (Point3& p : there.points) p = moved(p, distance, direction);
      if (auto light = standing_apart(there, blocker)) return *light;
    }
  }
  throw std::logic_error("no place was found for the light");
}

template <class Map>
Points mapped(Points points, Map map) {
  for (Point3& p : points) p = map(p);
  return points;
}

/// The pair after both have been mapped, or nothing if that is no pair in standard position.
template <class LightMap, class BlockerMap>
std::optional<Pair> mapped(const Pair& pair, LightMap light_map, BlockerMap blocker_map) {
  const auto old = pair.blocker.points();
  const auto blocker = flat_polygon(mapped({old.begin(), old.end()}, blocker_map));
  if (!blocker) return std::nullopt;
  const auto* area = std::get_if<AreaLight>(&pair.light);
  const auto light = standing_apart({mapped(light_points(pair.light), light_map), area && area->two_sided}, *blocker);
  return light ? std::optional(Pair{*light, *blocker}) : std::nullopt;
}

void replace_if(Pair& pair, const std::optional<Pair>& bent) {
  if (bent) pair = *bent;
}

Points with_nudged_vertex(Points points) {
  Point3& vertex = points[std::size_t(draw(0, int(points.size()) - 1))];
  vertex = nudged(vertex);
  return points;
}

/// Moves one vertex by one ulp. It stays in its polygon's plane only where that is parallel to the axes; elsewhere, and
/// where the polygon is no longer convex, the pair is left as it is.
void nudge_a_vertex(Pair& pair) {
  const auto untouched = [](const Point3& p) { return p; };
  if (once_in(2)) {
    const Points bent = with_nudged_vertex(light_points(pair.light));
    std::size_t next = 0;
    replace_if(pair, mapped(
                         pair, [&](const Point3&) { return bent[next++]; }, untouched));
  } else {
    const auto old = pair.blocker.points();
    const Points bent = with_nudged_vertex({old.begin(), old.end()});
    std::size_t next = 0;
    replace_if(pair, mapped(pair, untouched, [&](const Point3&) { return bent[next++]; }));
  }
}

/// Bends a pair toward degeneracy; what would leave standard position is left out.
void bend(Pair& pair) {
  const double size = std::ldexp(1.0, draw(0, 3) * 10 + 10);
  const Point3 offset = draw_vector(2);
  const auto far = [&](const Point3& p) { return moved(p, size, offset); };
  const auto large = [&](const Point3& p) { return moved({}, size, p); };
  const auto small = [&](const Point3& p) { return moved({}, 1 / size, p); };
  const auto same = [](const Point3& p) { return p; };
  switch (draw(0, 4)) {
    case 0:
      break;
    case 1:
      replace_if(pair, mapped(pair, far, far));
      break;
    case 2:
      replace_if(pair, mapped(pair, large, same));
      break;
    case 3:
      replace_if(pair, mapped(pair, same, small));
      break;
    default:
      replace_if(pair, mapped(pair, small, same));
      break;
  }
  for (int left = draw(0, 3); left > 0; --left) nudge_a_vertex(pair);
}

}  // namespace

Point3 nudged(const Point3& p) {
  Point3 result = p;
  double& coordinate = *std::array{&result.x, &result.y, &result.z}[std::size_t(draw(0, 2))];
  const double sense = once_in(2) ? -1 : 1;
  if (coordinate == 0) {
    coordinate = sense * (once_in(4) ? std::numeric_limits<double>::denorm_min() : std::ldexp(1.0, -53));
  } else {
    coordinate = std::nextafter(coordinate, sense * std::numeric_limits<double>::infinity());
  }
  return result;
}

Point3 nudged_beside_whole_numbers(const Point3& p) {
  Point3 q = nudged(p);
  for (double* c : {&q.x, &q.y, &q.z}) {
    if (std::abs(*c) < 0x1p-60) *c = 0;
  }
  return q;
}

std::vector<Point3> draw_flat_points(double stretch) {
  return draw_polygon(stretch);
}

std::vector<Point3> light_points(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light)) return {point->position};
  if (const auto* linear = std::get_if<LinearLight>(&light)) return {linear->start, linear->end};
  const auto points = std::get<AreaLight>(light).polygon.points();
  return {points.begin(), points.end()};
}

Pair draw_pair(Domain domain, Lights lights) {
  const bool bent = domain == Domain::near_degenerate;
  const double blocker_stretch = bent && once_in(4) ? std::ldexp(1.0, draw(1, 3) * 10) : 1;
  const double light_stretch = bent && once_in(4) ? std::ldexp(1.0, draw(1, 3) * 10) : 1;
  const Points points = draw_polygon(blocker_stretch);
  const ConvexPolygon blocker = ConvexPolygon::from_points(points);
  Pair pair{placed(draw_emitter(lights, points, light_stretch), blocker), blocker};
  if (bent) bend(pair);
  return pair;
}

}  // namespace gnomon::laws
