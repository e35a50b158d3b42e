#include "geometry/conics/curve_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/conics/arc_area.h"

namespace gnomon::conic {
namespace {

/// The circle of radius 1 around a point, but for the point on its left: by lines through that point and, across them,
/// through the opposite one.
std::vector<FlatArc> circle(int x, int y, const Range& range = {-100, 100}) {
  const auto covector = [&](int w, int along_x, int along_y) {
    return std::array<Rational, 3>{Rational(w - along_x * x - along_y * y), Rational(along_x), Rational(along_y)};
  };
  return arcs(line_pencil(covector(0, 0, -1), covector(1, 1, -1)), line_pencil(covector(-1, 1, 0), covector(-1, 1, 1)),
              range, 1000);
}

/// A horizontal or vertical or slanting segment.
NamedArc segment(const FlatPoint& from, const FlatPoint& to, std::uint32_t name) {
  FlatCurve curve = straight_curve(line_through(from, to));
  const bool by_x = curve.parameters.front().start[1] != 0;
  const Rational a = by_x ? from.x : from.y, b = by_x ? to.x : to.y;
  return {{std::move(curve), std::min(a, b), std::max(a, b)}, name};
}

void append_ring(const std::vector<FlatPoint>& corners, std::vector<Side>& sides) {
  const auto first = static_cast<std::uint32_t>(sides.size()), n = static_cast<std::uint32_t>(corners.size());
  for (std::uint32_t k = 0; k < n; ++k) {
    sides.push_back({corners[k], corners[(k + 1) % n], first + k, first + (k + 1) % n, first + k, false});
  }
}

std::vector<Side> square(int half_width) {
  const int h = half_width;
  std::vector<Side> sides;
  append_ring({{-h, -h}, {h, -h}, {h, h}, {-h, h}}, sides);
  return sides;
}

std::vector<NamedArc> named(std::vector<FlatArc> arcs, std::uint32_t name = 0) {
  std::vector<NamedArc> result;
  for (FlatArc& arc : arcs) result.push_back({std::move(arc), name});
  return result;
}

std::vector<NamedArc> operator+(std::vector<NamedArc> a, const std::vector<NamedArc>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// The signs of all curves' forms at a cell's inner point: never 0.
std::set<std::vector<int>> signs_of_cells(const CurveMap& map) {
  std::set<std::vector<int>> all;
  for (std::size_t c = 0; c < map.cells().size(); ++c) {
    std::vector<int> signs;
    for (const FlatCurve& curve : map.curves()) signs.push_back(side(curve, map.inner_point(c)));
    EXPECT_EQ(std::ranges::count(signs, 0), 0);
    all.insert(std::move(signs));
  }
  return all;
}

/// The formula of Euler: a wrong order of pieces around a node would leave fewer cycles.
void expect_planar(const CurveMap& map, std::size_t holes = 0) {
  std::set<std::uint32_t> nodes;
  for (const CurveMap::Piece& p : map.pieces()) nodes.insert({p.start, p.end});
  EXPECT_EQ(map.cells().size() + holes, map.pieces().size() - nodes.size() + 1);
}

std::size_t most_pieces_at_a_node(const CurveMap& map) {
  std::vector<std::size_t> at(map.nodes().size());
  for (const CurveMap::Piece& p : map.pieces()) ++at[p.start], ++at[p.end];
  return *std::ranges::max_element(at);
}

// The circle around (x, y) lacks the point (x - 1, y): pieces that lead there are loose.

TEST(CurveMap, OfNoArcsIsThePolygon) {
  EXPECT_EQ(CurveMap(square(2), {}).cells().size(), 1U);
}

TEST(CurveMap, OfAnArcThatEndsInsideIsThePolygon) {
  const std::vector<Side> sides = square(2);
  EXPECT_EQ(CurveMap(sides, named(circle(0, 0))).cells().size(), 1U);
  EXPECT_EQ(CurveMap(sides, named(circle(2, 0, {Rational(-1, 2), Rational(1, 2)}))).cells().size(), 1U);
}

TEST(CurveMap, OfAnArcThroughTwoSidesHasTwoCells) {
  const CurveMap map(square(2), named(circle(-2, -2)));
  expect_planar(map);
  EXPECT_EQ(map.cells().size(), 2U);
  EXPECT_EQ(signs_of_cells(map).size(), 2U);
}

TEST(CurveMap, BringsArcsOfOneConicTogetherWhoseParametersAreInfiniteOnEachOther) {
  // The left point of the circle is infinite on its own parameter, the point at 1/64 on the other's.
  const FlatArc first = circle(0, 0, {-1, 3}).front();
  const FlatCurve other = with_pole(first.curve, Rational(1, 64));
  const auto moved = [](const Rational& t) -> Rational { return Rational(-63, 64) * t / (Rational(1, 64) - t); };
  EXPECT_EQ(other.at(moved(3)).value(), first.curve.at(3).value());
  // From 2 over infinity to -2. A chord closes the gap to -1.
  const FlatArc second{other, std::min(moved(2), moved(-2)), std::max(moved(2), moved(-2))};
  const NamedArc chord = segment(first.curve.at(-2).value(), first.curve.at(-1).value(), 2);
  for (const bool is_first : {true, false}) {
    const std::vector<NamedArc> arcs =
        is_first ? named({first}) + named({second}, 1) : named({second}) + named({first}, 1);
    const CurveMap map(square(2), arcs + std::vector{chord});
    ASSERT_TRUE(map.is_complete());
    expect_planar(map);
    EXPECT_EQ(signs_of_cells(map).size(), 2U);
    EXPECT_EQ(CurveMap(square(2), arcs).cells().size(), 1U);
  }
}

TEST(CurveMap, IsNotCompleteWhereArcsCoverAllOfAConic) {
  const FlatArc most = circle(0, 0, {-1000, 1000}).front();
  const FlatCurve other = with_pole(most.curve, Rational(1, 64));
  const FlatArc all{other, -100000, 100000};
  EXPECT_FALSE(CurveMap(square(2), named({most}) + named({all}, 1)).is_complete());
}

TEST(CurveMap, OfAnArcThroughAVertexHasTwoCells) {
  const CurveMap map(square(2), named(circle(-2, -1)));
  expect_planar(map);
  EXPECT_EQ(map.cells().size(), 2U);
}

TEST(CurveMap, OfAnArcThatTouchesTwoSidesHasTheCornerForACell) {
  const CurveMap touching(square(2), named(circle(1, 1)));
  expect_planar(touching);
  EXPECT_EQ(touching.cells().size(), 2U);
  const CurveMap closed(square(2), named(circle(1, 1)) + std::vector{segment({1, -2}, {1, 2}, 1)});
  expect_planar(closed);
  EXPECT_EQ(closed.cells().size(), 4U);
}

TEST(CurveMap, OfTwoCirclesThatTouchALineInOnePointHasSixCells) {
  const std::vector<NamedArc> all = named(circle(0, 1), 0) + named(circle(0, -1), 1) +
                                    std::vector{segment({-3, 0}, {3, 0}, 2), segment({0, -3}, {0, 3}, 3)};
  const CurveMap map(square(3), all);
  expect_planar(map);
  EXPECT_EQ(map.cells().size(), 6U);
  EXPECT_EQ(signs_of_cells(map).size(), 6U);
  EXPECT_EQ(most_pieces_at_a_node(map), 6U);
}

TEST(CurveMap, OfCurvesThroughOnePointHasOneNodeThere) {
  const std::vector<NamedArc> all = named(circle(0, 1), 0) + named(circle(-1, 0), 1) +
                                    std::vector{segment({-1, -2}, {1, 2}, 2), segment({-3, 0}, {3, 0}, 3)};
  const CurveMap map(square(3), all);
  expect_planar(map);
  signs_of_cells(map);
  EXPECT_GE(most_pieces_at_a_node(map), 5U);
}

TEST(CurveMap, OfAnArcAlongASideIgnoresIt) {
  EXPECT_EQ(CurveMap(square(2), std::vector{segment({-2, 2}, {1, 2}, 0)}).cells().size(), 1U);
}

TEST(CurveMap, TakesTheSameArcTwiceForOne) {
  const std::vector<NamedArc> twice = named(circle(-2, -2), 0) + named(circle(-2, -2, {-3, 3}), 1);
  const CurveMap map(square(2), twice);
  EXPECT_EQ(map.cells().size(), 2U);
  const auto both = std::ranges::find_if(map.pieces(), [](const CurveMap::Piece& p) { return !p.names.empty(); });
  ASSERT_NE(both, map.pieces().end());
  EXPECT_EQ(both->names, (std::vector<std::uint32_t>{0, 1}));
}

TEST(CurveMap, JoinsIslandsAndHolesToTheOuterBoundary) {
  // The hole's sides come first. Around it lies an island of four lines that meet no side.
  std::vector<Side> sides;
  append_ring({{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}, sides);
  append_ring({{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, sides);
  const std::vector<NamedArc> island{segment({-3, -2}, {3, -2}, 0), segment({2, -3}, {2, 3}, 1),
                                     segment({3, 2}, {-3, 2}, 2), segment({-2, 3}, {-2, -3}, 3)};
  const CurveMap map(sides, island);
  expect_planar(map, 1);
  std::set<bool> inside;
  for (std::size_t c = 0; c < map.cells().size(); ++c) {
    const FlatPoint p = map.inner_point(c);
    inside.insert(abs(p.x) < 2 && abs(p.y) < 2);
    EXPECT_TRUE(abs(p.x) > 1 || abs(p.y) > 1);
  }
  EXPECT_EQ(inside.size(), 2U);
  EXPECT_EQ(CurveMap(sides, {}).cells().size(), 1U);
}

TEST(ArcArea, OfPartsOfACircleIsTheSectorLessTheTriangle) {
  // A quarter of the circle, from t = 0 at (1, 0) to t = 1 at (0, 1), and two halves of it.
  const FlatCurve curve = circle(0, 0).front().curve;
  RealRoot from = rational_root(0), to = rational_root(1);
  const RationalInterval quarter = doubled_segment(curve, from, to, 100);
  EXPECT_NEAR(quarter.low.convert_to<double>(), 0.5707963267948966, 1e-15);
  EXPECT_LT(quarter.width(), Rational(1, Integer(1) << 90));
  RealRoot back = rational_root(-3);
  EXPECT_NEAR(doubled_segment(curve, back, to, 100).low.convert_to<double>(),
              2 * (std::atan(1) + std::atan(3)) - std::sin(2 * (std::atan(1) + std::atan(3))), 1e-14);
}

}  // namespace
}  // namespace gnomon::conic
