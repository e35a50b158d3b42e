#include "apps/proof/laws/claim_cases.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/exact.h"
#include "apps/proof/laws/pair_generator.h"
#include "gnomon/shadow_volume.h"

namespace gnomon::laws {
namespace {

using Points = std::vector<Point3>;

Point3 difference(const Point3& a, const Point3& b) {
  return moved(a, -1, b);
}

/// A triangle with the light's vertex i, or a parallelogram on the light's edge from it; by chance in the light's
/// plane, or no polygon, and then another one is taken.
Points draw_on_vertex(const Points& light, std::size_t i) {
  const Point3& a = light[i];
  const Point3 away = draw_vector(3);
  Points blocker{a, moved(a, 1, away), moved(a, 1, draw_vector(3))};
  if (once_in(2)) {
    const Point3& b = light[(i + 1) % light.size()];
    blocker = {a, b, moved(b, 1, away), moved(a, 1, away)};
  }
  return ConvexPolygon::defect(blocker) ? Points{a, moved(a, 1, {0, 1, 3}), moved(a, 1, {1, 0, 2})} : blocker;
}

/// The same, of some the first whose plane does not cross the light, if there is one.
Points draw_beside(const Points& light, std::size_t i) {
  Points blocker = draw_on_vertex(light, i);
  for (int more = draw(0, 3); more > 0 && !common_side(plane_of(exact(blocker)), exact(light)); --more) {
    blocker = draw_on_vertex(light, i);
  }
  return blocker;
}

/// The linear map x + s z, y + t z with a permutation of axes, and a shift.
struct Move {
  double s;
  double t;
  int turn;
  Point3 shift;

  Point3 operator()(const Point3& p) const {
    const double c[] = {p.x + s * p.z, p.y + t * p.z, p.z};
    return moved(shift, 1, {c[turn], c[(turn + 1) % 3], c[(turn + 2) % 3]});
  }
};

Move draw_move() {
  const double s = draw(-2, 2), t = draw(-2, 2);
  const int turn = draw(0, 2);
  return {s, t, turn, draw_vector(5)};
}

Points rectangle(double x0, double x1, double y0, double y1, double z) {
  return {{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}};
}

Points all_moved(Points points, const Move& move) {
  for (Point3& p : points) p = move(p);
  return points;
}

void move_all(PocketCase& drawn, const Move& move) {
  const auto& light = std::get<AreaLight>(drawn.visibility.light);
  const Points lamp = all_moved(light_points(light), move);
  const auto solid = std::get<ConvexSolid>(drawn.visibility.blockers.front()).points();
  drawn.visibility.light = AreaLight{ConvexPolygon::from_points(lamp), light.two_sided};
  drawn.visibility.blockers = {ConvexSolid::hull_of(all_moved({solid.begin(), solid.end()}, move))};
  drawn.visibility.point = move(drawn.visibility.point);
  drawn.other = move(drawn.other);
  for (Point3& p : drawn.plane) p = move(p);
}

}  // namespace

rc::Gen<VisibilityCase> pairs_that_share(Domain domain) {
  return rc::gen::exec([=] {
    const Points light = draw_flat_points(1);
    const std::size_t i = std::size_t(draw(0, int(light.size()) - 1));
    const Points blocker = draw_beside(light, i);
    const Point3 b = between(between(blocker[0], 0.25 * draw(0, 4), blocker[1]), 0.125 * draw(-1, 4), blocker[2]);
    const Point3 l = between(light[std::size_t(draw(0, int(light.size()) - 1))], 0.25 * draw(0, 3), light[i]);
    Point3 p = moved(b, 0.125 * draw(1, 12), difference(b, l));
    if (domain == Domain::near_degenerate && once_in(2)) p = nudged(p);
    return VisibilityCase{
        AreaLight{ConvexPolygon::from_points(light), !once_in(4)}, {ConvexPolygon::from_points(blocker)}, p};
  });
}

rc::Gen<VisibilityCase> cut_boards(Domain domain) {
  return rc::gen::exec([=] {
    const Move move = draw_move();
    const double lamp = draw(1, 4), left = draw(1, 4), right = draw(1, 4), low = draw(1, 4), high = draw(1, 4);
    const double x = draw(-2, 2), y = draw(-2, 2), depth = draw(1, 8), height = draw(1, 4);
    Point3 p = move({x / 2, y / 2, -depth / 4});
    if (domain == Domain::near_degenerate && once_in(2)) p = nudged(p);
    const auto board = [&](double x0, double x1, double y1) {
      return ConvexPolygon::from_points(all_moved(rectangle(x0, x1, -high, y1, 0), move));
    };
    return VisibilityCase{
        AreaLight{ConvexPolygon::from_points(all_moved(rectangle(-lamp, lamp, -lamp, lamp, height), move)), true},
        {board(-left, 0, high), board(0, right, low)},
        p};
  });
}

std::string description(const PocketCase& drawn) {
  return description(drawn.visibility) + "other " +
         description(VisibilityCase{PointLight{drawn.other}, {}, drawn.plane[0]});
}

Example example(const PocketCase& drawn) {
  Example result = example(drawn.visibility);
  result.points.push_back(drawn.other);
  return result;
}

void count_regions(const PocketCase& drawn, Census& census) {
  count_regions(drawn.visibility, census);
}

PocketCase pyramid_case(const PyramidMeasures& measures) {
  const Points lamp = rectangle(-measures.lamp_length, measures.lamp_length, -measures.lamp_width, measures.lamp_width,
                                measures.height);
  const Points pyramid{{1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {-1, 1, 0}, {0, 0, -measures.depth}};
  return {{AreaLight{ConvexPolygon::from_points(lamp), false},
           {ConvexSolid::hull_of(pyramid)},
           {0, measures.aside, -measures.below}},
          {0, -measures.aside, -measures.below},
          {Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 0, 1}}};
}

rc::Gen<PocketCase> pyramid_cases(Domain domain) {
  return rc::gen::exec([=] {
    const Move move = draw_move();
    const double length = draw(1, 8), width = draw(1, 4), height = draw(1, 3), depth = draw(1, 3);
    const double aside = draw(4, 8), below = draw(1, 4);
    PocketCase drawn = pyramid_case({length, width / 8, height, depth, aside / 8, below / 8 * depth});
    move_all(drawn, move);
    if (domain == Domain::near_degenerate && once_in(2)) drawn.other = nudged(drawn.other);
    return drawn;
  });
}

}  // namespace gnomon::laws
