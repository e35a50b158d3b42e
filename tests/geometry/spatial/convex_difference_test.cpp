#include "geometry/spatial/convex_difference.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include <CGAL/convex_hull_2.h>

#include "tests/support/dice.h"

namespace gnomon {
namespace {

using test_support::Dice;
using Point = ExactKernel::Point_2;

ConvexLoop hull(const std::vector<Point>& points) {
  ConvexLoop loop;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(loop));
  return loop;
}

/// +1 inside, 0 on the boundary, -1 outside.
int side_of(const ConvexLoop& loop, const Point& p) {
  int least = 1;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    least = std::min<int>(least, CGAL::orientation(loop[k], loop[(k + 1) % loop.size()], p));
  }
  return least;
}

Point draw_point(Dice& dice) {
  const int x = dice.draw(0, 6);
  return {x, dice.draw(0, 6)};
}

ConvexLoop draw_whole(Dice& dice) {
  if (dice.once_in(3)) return {Point(0, 0), Point(6, 0), Point(6, 6), Point(0, 6)};
  for (;;) {
    std::vector<Point> points;
    for (int i = dice.draw(3, 7); i > 0; --i) points.push_back(draw_point(dice));
    if (ConvexLoop loop = hull(points); loop.size() > 2) return loop;
  }
}

/// The hull of three to six points of a small grid inside of the whole: shared edges and corners are common.
ConvexLoop draw_part(Dice& dice, const ConvexLoop& whole) {
  for (;;) {
    std::vector<Point> points;
    for (int i = dice.draw(3, 6); i > 0; --i) {
      const Point p = draw_point(dice);
      points.push_back(side_of(whole, p) >= 0 ? p : dice.one_of(whole));
    }
    if (ConvexLoop loop = hull(points); loop.size() > 2) return loop;
  }
}

/// How often closed edges wind around a point that lies on none of them: crossings of the ray to the right.
int winding(const std::vector<BoundaryEdge>& edges, const Point& p) {
  int turns = 0;
  for (const auto& [a, b] : edges) {
    if (a.y() <= p.y() && b.y() > p.y() && CGAL::orientation(a, b, p) == CGAL::LEFT_TURN) ++turns;
    if (a.y() > p.y() && b.y() <= p.y() && CGAL::orientation(a, b, p) == CGAL::RIGHT_TURN) --turns;
  }
  return turns;
}

bool is_on(const BoundaryEdge& edge, const Point& p) {
  return CGAL::collinear(edge[0], edge[1], p) && CGAL::collinear_are_ordered_along_line(edge[0], p, edge[1]);
}

/// Two edges have no point in common, or ends.
bool meet_at_ends_only(const BoundaryEdge& e, const BoundaryEdge& f) {
  for (const Point& p : f) {
    if (is_on(e, p) && p != e[0] && p != e[1]) return false;
  }
  for (const Point& p : e) {
    if (is_on(f, p) && p != f[0] && p != f[1]) return false;
  }
  if (e[0] == f[0] && e[1] == f[1]) return false;
  if (e[0] == f[1] && e[1] == f[0]) return false;
  const bool crosses_e = CGAL::orientation(e[0], e[1], f[0]) * CGAL::orientation(e[0], e[1], f[1]) < 0;
  const bool crosses_f = CGAL::orientation(f[0], f[1], e[0]) * CGAL::orientation(f[0], f[1], e[1]) < 0;
  return !crosses_e || !crosses_f;
}

RC_GTEST_PROP(ConvexDifferenceProperty, WindsOnceAroundWhatIsInTheWholeAndNotTakenAndNeverAroundTheRest, ()) {
  Dice dice;
  const ConvexLoop whole = draw_whole(dice);
  std::vector<ConvexLoop> taken;
  for (int i = dice.draw(0, 4); i > 0; --i) {
    taken.push_back(!taken.empty() && dice.once_in(6) ? ConvexLoop(dice.one_of(taken)) : draw_part(dice, whole));
  }
  const std::vector<BoundaryEdge> edges = convex_difference(whole, taken);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    RC_ASSERT(edges[i][0] != edges[i][1]);
    for (std::size_t j = 0; j < i; ++j) RC_ASSERT(meet_at_ends_only(edges[i], edges[j]));
  }
  for (int k = 0; k < 60; ++k) {
    const Point p(ExactKernel::FT(dice.draw(-10, 70)) / 10 + ExactKernel::FT(1) / 997,
                  ExactKernel::FT(dice.draw(-10, 70)) / 10 + ExactKernel::FT(1) / 1009);
    if (std::any_of(edges.begin(), edges.end(), [&](const BoundaryEdge& e) { return is_on(e, p); })) continue;
    const bool is_taken =
        std::any_of(taken.begin(), taken.end(), [&](const ConvexLoop& t) { return side_of(t, p) > 0; });
    RC_ASSERT(winding(edges, p) == (side_of(whole, p) > 0 && !is_taken ? 1 : 0));
  }
}

TEST(ConvexDifferenceDegenerate, NothingIsLeftOfWhatIsTakenInTwoHalves) {
  const ConvexLoop square{Point(0, 0), Point(4, 0), Point(4, 4), Point(0, 4)};
  const std::vector<ConvexLoop> halves{{Point(0, 0), Point(4, 0), Point(0, 4)},
                                       {Point(4, 0), Point(4, 4), Point(0, 4)}};
  EXPECT_TRUE(convex_difference(square, halves).empty());
}

TEST(ConvexDifferenceDegenerate, WhatTouchesAnEdgeAtAPointDividesIt) {
  const ConvexLoop square{Point(0, 0), Point(4, 0), Point(4, 4), Point(0, 4)};
  const std::vector<ConvexLoop> taken{{Point(2, 0), Point(3, 2), Point(1, 2)}};
  EXPECT_EQ(convex_difference(square, taken).size(), 5U + 3U);
}

}  // namespace
}  // namespace gnomon
