#include "apps/proof/laws/triple_edge_cases.h"

#include <cmath>
#include <sstream>
#include <vector>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/pair_generator.h"
#include "geometry/bodies/polygon_checks.h"

namespace gnomon::laws {
namespace {

using Corners = std::vector<Point3>;

ExactVector draw_place(int low, int high) {
  const Point3 p = draw_vector(4);
  return {Rational(p.x), Rational(p.y), Rational(draw(low, high))};
}

TripleCase draw_triple(Domain domain) {
  TripleCase drawn;
  for (Segment& edge : drawn.edges) {
    edge = {draw_place(1, 6), draw_place(1, 6)};
    if (is_zero(edge[1] - edge[0])) edge[1].x += 1;
  }
  if (domain == Domain::near_degenerate) {
    // Parallel to the first edge, or through a point of it, but for an ulp.
    Segment& edge = drawn.edges[1];
    edge[1] =
        once_in(2) ? edge[0] + (drawn.edges[0][1] - drawn.edges[0][0]) : edge[0] + 2 * (drawn.edges[0][0] - edge[0]);
    if (is_zero(edge[1] - edge[0])) edge[1].y += 1;
    edge[1].z += Rational(draw(-1, 1)) * Rational(0x1p-50);
  }
  drawn.start = draw_place(0, 0);
  drawn.step = draw_place(0, 0);
  if (is_zero(drawn.step)) drawn.step.x = 1;
  drawn.share = Rational(draw(1, 15), 16);
  return drawn;
}

/// A triangle at some height, perhaps tilted, an upright board, or a box.
Corners draw_board(int height) {
  const double z = height;
  const double x = draw(-2, 1), y = draw(-2, 1);
  if (once_in(6)) return {{x - 1, y, z}, {x + 3, y, z}, {x + 3, y, z + 1}, {x - 1, y, z + 1}};  // upright
  if (once_in(4)) {
    Corners corners;
    for (int c = 0; c < 8; ++c) corners.push_back({x + (c & 1 ? 2 : 0), y + (c & 2 ? 3 : 0), z + (c & 4 ? 0.5 : 0)});
    return corners;
  }
  const double tilt = draw(-3, 3) / 8.0;
  return {{x + draw(-2, 0), y + draw(-1, 1), z},
          {x + draw(2, 4), y + draw(-2, 1), z + tilt},
          {x + draw(-1, 2), y + draw(2, 4), z - tilt}};
}

ConvexBlocker board_of(Corners corners) {
  if (corners.size() > 4) return ConvexSolid::hull_of(corners);
  if (ConvexPolygon::defect(corners)) corners = {{-2, -1, 1}, {3, -2, 1}, {0, 3, 1}};
  return ConvexPolygon::from_points(corners);
}

Corners draw_lamp(bool is_tube) {
  const double x = draw(-2, 0), y = draw(-2, 0), size = draw(1, 3);
  if (is_tube) return {{x, y, 6}, {x + size, y + draw(-1, 1), 6.0 + draw(-1, 1)}};
  return {{x, y, 6}, {x, y + size, 6}, {x + size, y + size, 6}, {x + size, y, 6}};
}

ReceiverCase draw_joint(Domain domain) {
  const bool is_bent = domain == Domain::near_degenerate, is_far = is_bent && once_in(3);
  const bool is_tube = once_in(2);
  Corners lamp = draw_lamp(is_tube), floor{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}};
  const auto place = [&](Corners& corners) {
    if (!is_far) return;
    for (Point3& p : corners)
      p = {std::ldexp(p.x, -10) + 4096, std::ldexp(p.y, -10) - 4096, std::ldexp(p.z, -10) + 4096};
  };
  ReceiverCase drawn{
      PointLight{{0, 0, 6}}, {}, ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 0, 0.5, {}};
  const int count = once_in(4) ? 3 : 2;
  for (int k = 0; k < count; ++k) {
    // Now and then in the plane of the one before, which it then crosses, touches or shares an edge with.
    Corners board = draw_board(k > 0 && once_in(4) ? k : k + 1);
    if (is_bent && board.size() == 3 && once_in(2)) board[1] = nudged_beside_whole_numbers(board[1]);
    place(board);
    drawn.blockers.push_back(board_of(board));
  }
  place(lamp);
  place(floor);
  if (is_tube) {
    drawn.light = LinearLight{lamp[0], lamp[1]};
  } else {
    drawn.light = AreaLight{ConvexPolygon::from_points(lamp)};
  }
  drawn.floor = ConvexPolygon::from_points(floor);
  drawn.choice = static_cast<std::uint32_t>(draw(0, 9999));
  drawn.direction = {1, 0, 0};
  return drawn;
}

}  // namespace

std::string description(const TripleCase& drawn) {
  std::ostringstream out;
  const auto tell = [&](const char* what, const ExactVector& p) {
    out << what << ' ' << p.x << ' ' << p.y << ' ' << p.z << '\n';
  };
  for (const Segment& edge : drawn.edges) tell("from", edge[0]), tell("to", edge[1]);
  tell("start", drawn.start);
  tell("step", drawn.step);
  out << "share " << drawn.share << '\n';
  return out.str();
}

rc::Gen<TripleCase> triple_cases(Domain domain) {
  return rc::gen::exec([domain] { return draw_triple(domain); });
}

rc::Gen<ReceiverCase> joint_cases(Domain domain) {
  return rc::gen::exec([domain] { return draw_joint(domain); });
}

}  // namespace gnomon::laws
