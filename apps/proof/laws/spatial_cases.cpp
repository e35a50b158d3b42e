#include "apps/proof/laws/spatial_cases.h"

#include <iomanip>
#include <span>
#include <sstream>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/pair_generator.h"
#include "apps/proof/laws/point_text.h"
#include "gnomon/shadow_volume.h"
#include "gnomon/visibility.h"

namespace gnomon::laws {
namespace {

using Points = std::vector<Point3>;

const Point3& draw_one(const Points& points) {
  return points[std::size_t(draw(0, int(points.size()) - 1))];
}

/// A vertex, a point on the line of two vertices, or one of a triangle; with an overhang also beside the polygon.
/// Quarters of small integers, so exact as a double.
Point3 draw_near(const Points& points, int overhang) {
  const Point3 a = draw_one(points);
  if (points.size() == 1 || once_in(3)) return a;
  const Point3 b = draw_one(points);
  const Point3 p = moved(a, 0.25 * draw(-overhang, 4 + overhang), moved(b, -1, a));
  if (!once_in(3)) return p;
  const Point3 c = draw_one(points);
  return moved(p, 0.25 * draw(0, 4), moved(c, -1, p));
}

/// A point on a line through the light and the blocker, or near: beyond the blocker it is in the shadow, with vertices
/// it is on extremal planes.
Point3 draw_aligned(const Points& light, const Points& blocker) {
  const Point3 l = draw_near(light, once_in(4) ? 1 : 0);
  const Point3 b = draw_near(blocker, once_in(4) ? 1 : 0);
  const double steps[] = {1, 0.5, 2, 0.25, 3, 8, 0, -0.5, -1, -2};
  return moved(b, steps[draw(0, 9)], moved(b, -1, l));
}

/// A point behind a corner of the blocker, seen from a place beside the middle of a light edge: often beyond the plane
/// of that light edge alone.
Point3 draw_beside_a_light_edge(const Points& light, const Points& blocker) {
  const std::size_t i = std::size_t(draw(0, int(light.size()) - 1));
  const Point3 middle = moved(light[i], 0.5, moved(light[(i + 1) % light.size()], -1, light[i]));
  const Point3 from = draw_one(once_in(2) ? light : blocker);
  const Point3 to = draw_one(once_in(2) ? light : blocker);
  const Point3 beside = moved(middle, 0.125 * draw(0, 2), moved(to, -1, from));
  const Point3 corner = draw_one(blocker);
  return moved(corner, 0.5 * draw(1, 4), moved(corner, -1, beside));
}

/// A point on the way from the light, or from beside it, to the blocker, or to the point mirrored at the light.
Point3 draw_before_light(const Points& light, const Points& blocker) {
  const Point3 l = draw_near(light, 1);
  return moved(l, 0.125 * draw(-2, 6), moved(draw_near(blocker, 1), -1, l));
}

/// A point of the plane through an edge and a vertex of the other element.
Point3 draw_on_a_plane(const Points& light, const Points& blocker) {
  const bool through_light_edge = once_in(3) && light.size() > 1;
  const Points& edges = through_light_edge ? light : blocker;
  const std::size_t i = std::size_t(draw(0, int(edges.size()) - 1));
  const Point3 apex = draw_one(through_light_edge ? blocker : light);
  const Point3 on_edge = moved(edges[i], 0.5 * draw(-2, 4), moved(edges[(i + 1) % edges.size()], -1, edges[i]));
  return moved(on_edge, 0.5 * draw(-4, 4), moved(on_edge, -1, apex));
}

Point3 draw_point(Domain domain, const Pair& pair, View view) {
  const Points light = light_points(pair.light);
  const Points blocker(pair.blocker.points().begin(), pair.blocker.points().end());
  Point3 p;
  switch (view == View::before_light && once_in(2) ? 12 : draw(0, 11)) {
    case 0: {
      const int x = draw(-8, 8);
      const int y = draw(-8, 8);
      p = moved(blocker[0], 1, Point3{double(x), double(y), double(draw(-8, 8))});
      break;
    }
    case 1:
      p = draw_near(blocker, 2);
      break;
    case 2:
      p = draw_near(light, 2);
      break;
    case 3:
    case 4:
      p = draw_on_a_plane(light, blocker);
      break;
    case 5:
    case 6:
      p = draw_beside_a_light_edge(light, blocker);
      break;
    case 12:
      p = draw_before_light(light, blocker);
      break;
    default:
      p = draw_aligned(light, blocker);
      break;
  }
  return domain == Domain::near_degenerate && once_in(2) ? nudged(p) : p;
}

}  // namespace

std::string description(const SpatialCase& drawn) {
  std::ostringstream out;
  out << std::setprecision(17);
  const auto* area = std::get_if<AreaLight>(&drawn.light);
  write(out, area && area->two_sided ? "two-sided light" : "light", light_points(drawn.light));
  write(out, "blocker", drawn.blocker.points());
  write(out, "point", std::span(&drawn.point, 1));
  write(out, "other point", std::span(&drawn.other, 1));
  return out.str();
}

Example example(const SpatialCase& drawn) {
  const ConvexBlocker blocker = drawn.blocker;
  return spatial_example(drawn.light, std::span(&blocker, 1), {drawn.point, drawn.other});
}

void count_regions(const SpatialCase& drawn, Census& census) {
  census.add(shadow_volumes(drawn.light, drawn.blocker));
  census.add_point(exact_visibility(drawn.light, {{drawn.blocker}, {}}, drawn.point).region);
}

rc::Gen<SpatialCase> spatial_cases(Domain domain, Lights lights, View view) {
  return rc::gen::exec([=] {
    const Pair pair = draw_pair(domain, lights);
    const Point3 point = draw_point(domain, pair, view);
    return SpatialCase{pair.light, pair.blocker, point, draw_point(domain, pair, view)};
  });
}

}  // namespace gnomon::laws
