#include "apps/proof/laws/planar_cases.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <span>
#include <sstream>
#include <utility>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/point_text.h"
#include "gnomon/flatland_pair.h"
#include "gnomon/flatland_regions.h"

namespace gnomon::laws {
namespace {

Point2 draw_point2(int reach) {
  const int x = draw(-reach, reach);
  return {double(x), double(draw(-reach, reach))};
}

/// a + s * (b - a), rounded like any double.
Point2 between(const Point2& a, const Point2& b, double s) {
  return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
}

/// A light before a blocker that runs from (0, 0) to (4, 0).
std::vector<Point2> draw_light(Stand stand) {
  const bool is_point = once_in(8);
  const double foot = (stand == Stand::light_line_hits ? draw(0, 8) : draw(-4, 12)) * 0.5;
  const Point2 along{double(draw(-3, 3)), double(draw(1, 3))};
  const auto on_line = [&](int s) { return Point2{foot + s * along.x, s * along.y}; };
  const int near = draw(1, 3);
  const int far = near + draw(1, 3);
  switch (stand) {
    case Stand::apart: {
      const Point2 start{double(draw(-6, 10)), double(draw(1, 5))};
      const Point2 end{double(draw(-6, 10)), double(draw(1, 5))};
      if (is_point || start == end) return {start};
      return {start, end};
    }
    case Stand::light_line_hits:
      return {on_line(near), on_line(far)};
    case Stand::blocker_line_hits:
      return {on_line(once_in(3) ? 0 : -near), on_line(far)};
    default:
      if (is_point) return {{foot, 0}};
      return {{foot, 0}, {foot + 0.5 * draw(1, 12), 0}};
  }
}

/// A regular integer matrix and an integer offset.
struct Map {
  Point2 x_axis{1, 0};
  Point2 y_axis{0, 1};
  Point2 origin{0, 0};

  Point2 operator()(const Point2& p) const {
    return {origin.x + p.x * x_axis.x + p.y * y_axis.x, origin.y + p.x * x_axis.y + p.y * y_axis.y};
  }
};

Map draw_map() {
  Map map;
  map.origin = draw_point2(5);
  const Point2 x_axis = draw_point2(2);
  const Point2 y_axis = draw_point2(2);
  if (x_axis.x * y_axis.y != x_axis.y * y_axis.x) map.x_axis = x_axis, map.y_axis = y_axis;
  return map;
}

/// The point with one coordinate moved to a neighbouring double; a zero moves by 2^-53 or by the smallest double.
Point2 nudged(Point2 p) {
  double& coordinate = once_in(2) ? p.x : p.y;
  const double sense = once_in(2) ? -1 : 1;
  if (coordinate == 0) {
    coordinate = sense * (once_in(4) ? std::numeric_limits<double>::denorm_min() : std::ldexp(1.0, -53));
  } else {
    coordinate = std::nextafter(coordinate, sense * std::numeric_limits<double>::infinity());
  }
  return p;
}

template <class Change>
void change_all(PlanarCase& drawn, Change change) {
  for (Point2& p : drawn.light) p = change(p);
  for (Point2& p : drawn.blocker) p = change(p);
}

bool is_pair(const PlanarCase& drawn) {
  const bool has_light = drawn.light.size() == 1 || drawn.light.front() != drawn.light.back();
  return has_light && drawn.blocker[0] != drawn.blocker[1];
}

/// Moves one end of light or blocker to a neighbouring double, if that leaves both what they are.
void nudge_an_end(PlanarCase& drawn) {
  PlanarCase bent = drawn;
  Point2& p =
      once_in(2) ? bent.blocker[std::size_t(draw(0, 1))] : bent.light[std::size_t(draw(0, int(bent.light.size()) - 1))];
  p = nudged(p);
  if (is_pair(bent)) drawn = bent;
}

/// Bends a pair toward degeneracy: far off, one of the two large or small about the blocker's first end, stretched in
/// one direction, one ulp off.
void bend(PlanarCase& drawn) {
  const double size = std::ldexp(1.0, draw(0, 3) * 10 + 10);
  const Point2 offset = draw_point2(2);
  const Point2 center = drawn.blocker[0];
  PlanarCase bent = drawn;
  switch (draw(0, 5)) {
    case 0:
      change_all(bent, [&](const Point2& p) { return Point2{p.x + size * offset.x, p.y + size * offset.y}; });
      break;
    case 1:
      change_all(bent, [&](const Point2& p) { return Point2{p.x * size, p.y}; });
      break;
    case 2:
      change_all(bent, [&](const Point2& p) { return Point2{p.x, p.y / size}; });
      break;
    case 3:
      for (Point2& p : bent.light) p = between(center, p, size);
      break;
    case 4:
      bent.blocker[1] = between(center, bent.blocker[1], 1 / size);
      break;
    default:
      break;
  }
  if (is_pair(bent)) drawn = bent;
  for (int left = draw(0, 2); left > 0; --left) nudge_an_end(drawn);
}

/// On a line through the light and the blocker, behind the blocker or elsewhere.
Point2 draw_aligned(const PlanarCase& drawn) {
  const Point2 l = between(drawn.light.front(), drawn.light.back(), 0.25 * draw(0, 4));
  const Point2 b = between(drawn.blocker[0], drawn.blocker[1], 0.25 * draw(0, 4));
  const double steps[] = {-1, -0.5, -2, -0.25, -3, -8, 0, 0.5, 1, 2};
  return between(b, l, steps[draw(0, 9)]);
}

Point2 draw_point(Domain domain, const PlanarCase& drawn) {
  Point2 p;
  switch (draw(0, 9)) {
    case 0: {
      const Point2 step = draw_point2(8);
      p = {drawn.blocker[0].x + step.x, drawn.blocker[0].y + step.y};
      break;
    }
    case 1:
    case 2:
      p = between(drawn.blocker[0], drawn.blocker[1], 0.25 * draw(-4, 8));
      break;
    case 3:
      p = between(drawn.light.front(), drawn.light.back(), 0.25 * draw(-4, 8));
      break;
    default:
      p = draw_aligned(drawn);
      break;
  }
  return domain == Domain::near_degenerate && once_in(2) ? nudged(p) : p;
}

}  // namespace

std::string description(const PlanarCase& drawn) {
  std::ostringstream out;
  out << std::setprecision(17);
  write(out, "light", drawn.light);
  write(out, "blocker", drawn.blocker);
  write(out, "point", std::span(&drawn.point, 1));
  write(out, "other point", std::span(&drawn.other, 1));
  return out.str();
}

Example example(const PlanarCase& drawn) {
  return planar_example(drawn.light, std::span(&drawn.blocker, 1), std::array{drawn.point, drawn.other});
}

void count_regions(const PlanarCase& drawn, Census& census) {
  const planar::Pair pair = drawn.pair();
  census.add(planar::shadow_regions(pair));
  census.add_point(planar::region_of(pair, drawn.point));
}

rc::Gen<PlanarCase> planar_cases(Domain domain, Stand stand) {
  return rc::gen::exec([=] {
    const Stand drawn_stand = stand == Stand::any ? static_cast<Stand>(draw(0, 3)) : stand;
    PlanarCase drawn{draw_light(drawn_stand), {Point2{0, 0}, Point2{4, 0}}, {}, {}};
    change_all(drawn, draw_map());
    if (once_in(2)) std::swap(drawn.blocker[0], drawn.blocker[1]);
    if (once_in(2)) std::swap(drawn.light.front(), drawn.light.back());
    if (domain == Domain::near_degenerate) bend(drawn);
    drawn.point = draw_point(domain, drawn);
    drawn.other = draw_point(domain, drawn);
    return drawn;
  });
}

}  // namespace gnomon::laws
