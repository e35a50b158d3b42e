#include "apps/proof/laws/flatland_cases.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/point_text.h"
#include "gnomon/flatland.h"
#include "gnomon/flatland_partition.h"

namespace gnomon::laws {
namespace {

using planar::BlockerSegment;
using Blockers = std::vector<BlockerSegment>;

Point2 draw_point2(int reach) {
  const int x = draw(-reach, reach);
  return {double(x), double(draw(-reach, reach))};
}

Point2 between(const Point2& a, const Point2& b, double s) {
  return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
}

void add(Blockers& blockers, const Point2& a, const Point2& b) {
  if (a != b) blockers.push_back({a, b});
}

std::vector<Point2> draw_light() {
  const Point2 start = draw_point2(4);
  if (once_in(8)) return {start};
  const Point2 step = draw_point2(4);
  if (step == Point2{0, 0}) return {start, {start.x + 2, start.y}};
  return {start, {start.x + step.x, start.y + step.y}};
}

Blockers scattered(int count) {
  Blockers blockers;
  for (int i = 0; i < count; ++i) {
    const Point2 a = draw_point2(6);
    add(blockers, a, draw_point2(6));
  }
  return blockers;
}

Blockers chain(int count) {
  Blockers blockers;
  Point2 at = draw_point2(6);
  for (int i = 0; i < count; ++i) {
    const Point2 step = draw_point2(3);
    const Point2 next{at.x + step.x, at.y + step.y};
    add(blockers, at, next);
    at = next;
  }
  return blockers;
}

/// A blocker and one that goes on from its end, on the other side of a place of the light if that can be.
Blockers joint(const std::vector<Point2>& light, int count) {
  const Point2 at = draw_point2(6), l = between(light.front(), light.back(), 0.5);
  const Point2 visibility{at.x - l.x, at.y - l.y}, first = draw_point2(3), second = draw_point2(3);
  const double turn = visibility.x * first.y - visibility.y * first.x,
               other_turn = visibility.x * second.y - visibility.y * second.x;
  const double sense = turn * other_turn > 0 ? -1 : 1;
  Blockers blockers = scattered(count - 2);
  add(blockers, at, {at.x + first.x, at.y + first.y});
  add(blockers, at, {at.x + sense * second.x, at.y + sense * second.y});
  std::ranges::reverse(blockers);
  return blockers;
}

Blockers spiral(int count) {
  Blockers blockers;
  Point2 at = draw_point2(2);
  Point2 way{once_in(2) ? 1.0 : -1.0, 0};
  double length = draw(1, 2);
  for (int i = 0; i < count; ++i) {
    const Point2 next{at.x + length * way.x, at.y + length * way.y};
    add(blockers, at, next);
    at = next;
    way = {-way.y, way.x};
    length += draw(0, 2);
  }
  return blockers;
}

Blockers comb(int count) {
  Blockers blockers;
  const Point2 start = draw_point2(6);
  const Point2 step = draw_point2(2);
  const Point2 tooth = draw_point2(3);
  for (int i = 0; i < count; ++i) {
    const Point2 root{start.x + i * step.x, start.y + i * step.y};
    add(blockers, root, {root.x + tooth.x, root.y + tooth.y});
  }
  if (once_in(2)) add(blockers, start, {start.x + count * step.x, start.y + count * step.y});
  return blockers;
}

Blockers grid(int count) {
  Blockers blockers;
  for (int i = 0; i < count; ++i) {
    const Point2 a = draw_point2(3);
    const double length = draw(-3, 3);
    add(blockers, a, once_in(2) ? Point2{a.x + length, a.y} : Point2{a.x, a.y + length});
  }
  return blockers;
}

Blockers on_light(const std::vector<Point2>& light, int count) {
  Blockers blockers;
  for (int i = 0; i < count; ++i) {
    const Point2 on = between(light.front(), light.back(), 0.25 * draw(-4, 8));
    const Point2 step = draw_point2(3);
    switch (draw(0, 3)) {
      case 0:
        add(blockers, on, {on.x + step.x, on.y + step.y});
        break;
      case 1:
        add(blockers, {on.x - step.x, on.y - step.y}, {on.x + 2 * step.x, on.y + 2 * step.y});
        break;
      case 2:
        add(blockers, on, between(light.front(), light.back(), 0.25 * draw(-4, 8)));
        break;
      default:
        add(blockers, draw_point2(6), draw_point2(6));
    }
  }
  return blockers;
}

Blockers draw_blockers(Layout layout, const std::vector<Point2>& light, int count) {
  switch (layout) {
    case Layout::chain:
      return chain(count);
    case Layout::spiral:
      return spiral(count);
    case Layout::comb:
      return comb(count);
    case Layout::grid:
      return grid(count);
    case Layout::on_light:
      return on_light(light, count);
    case Layout::joint:
      return joint(light, count + 1);
    default:
      return scattered(count);
  }
}

Point2 draw_end(const FlatlandCase& drawn) {
  const int i = draw(-1, int(drawn.blockers.size()) - 1);
  const bool first = once_in(2);
  if (i < 0) return first ? drawn.light.front() : drawn.light.back();
  return drawn.blockers[std::size_t(i)][first ? 0 : 1];
}

/// A point behind a blocker as seen from a place of the light.
Point2 draw_hidden(const FlatlandCase& drawn) {
  const double steps[] = {1.5, 2, 1.25, 3, 9};
  const BlockerSegment& blocker = drawn.blockers[std::size_t(draw(0, int(drawn.blockers.size()) - 1))];
  const Point2 b = between(blocker[0], blocker[1], 0.25 * draw(0, 4));
  return between(between(drawn.light.front(), drawn.light.back(), 0.25 * draw(0, 4)), b, steps[draw(0, 4)]);
}

Point2 draw_view(const FlatlandCase& drawn) {
  const double steps[] = {-1, -0.5, -2, 0.5, 2, 3, 0, 1, -3, 1.5};
  if (once_in(2)) return draw_hidden(drawn);
  if (once_in(3)) {
    const Point2 p = draw_point2(10);
    return {p.x / 2, p.y / 2};
  }
  const Point2 a = draw_end(drawn), b = draw_end(drawn);
  return between(a, b, steps[draw(0, 9)]);
}

Point2 nudged(Point2 p) {
  double& coordinate = once_in(2) ? p.x : p.y;
  const double sense = once_in(2) ? -1 : 1;
  coordinate = coordinate == 0 ? sense * 0x1p-53 : std::nextafter(coordinate, sense * HUGE_VAL);
  return p;
}

/// Ends moved to a neighbouring double, all far off the origin, or stretched.
void bend(FlatlandCase& drawn) {
  const double size = std::ldexp(1.0, 10 * draw(0, 4));
  const Point2 offset = once_in(2) ? draw_point2(2) : Point2{0, 0};
  const double stretch = once_in(3) ? size : 1;
  const auto bent = [&](const Point2& p) { return Point2{p.x * stretch + size * offset.x, p.y + size * offset.y}; };
  for (Point2& p : drawn.light) p = bent(p);
  for (BlockerSegment& blocker : drawn.blockers) {
    for (Point2& p : blocker) p = bent(p);
  }
  for (BlockerSegment& blocker : drawn.blockers) {
    const BlockerSegment moved{once_in(4) ? nudged(blocker[0]) : blocker[0],
                               once_in(4) ? nudged(blocker[1]) : blocker[1]};
    if (moved[0] != moved[1]) blocker = moved;
  }
}

}  // namespace

std::string description(const FlatlandCase& drawn) {
  std::ostringstream out;
  out << std::setprecision(17);
  write(out, "light", drawn.light);
  for (const BlockerSegment& blocker : drawn.blockers) write(out, "blocker", blocker);
  write(out, "point", std::span(&drawn.point, 1));
  return out.str();
}

Example example(const FlatlandCase& drawn) {
  return planar_example(drawn.light, drawn.blockers, std::span(&drawn.point, 1));
}

void count_regions(const FlatlandCase& drawn, Census& census) {
  const planar::LightVisibility visibility(drawn.flatland());
  const planar::Partition partition = planar::partition(visibility);
  census.add_umbrae(partition.count(Region::umbra));
  census.add_penumbrae(partition.count(Region::penumbra));
  census.add_point(visibility.visible_light(drawn.point).region);
}

rc::Gen<FlatlandCase> flatland_cases(Domain domain, Layout layout, int most) {
  return rc::gen::exec([=] {
    const Layout chosen = layout == Layout::any ? static_cast<Layout>(draw(0, 5)) : layout;
    FlatlandCase drawn{draw_light(), {}, {}};
    drawn.blockers = draw_blockers(chosen, drawn.light, draw(1, most));
    if (drawn.blockers.empty()) drawn.blockers = {{Point2{0, 0}, Point2{1, 1}}};
    if (domain == Domain::near_degenerate) bend(drawn);
    drawn.point = draw_view(drawn);
    if (domain == Domain::near_degenerate && once_in(2)) drawn.point = nudged(drawn.point);
    return drawn;
  });
}

}  // namespace gnomon::laws
