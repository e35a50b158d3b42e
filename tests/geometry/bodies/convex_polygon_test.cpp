#include "gnomon/convex_polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "gnomon/errors.h"

namespace gnomon {
namespace {

using Kind = PolygonDefect::Kind;
using testing::ElementsAre;

std::vector<Point3> unit_square() {
  return {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
}

/// The kind of the defect; fails the test if there is none.
Kind kind(const std::vector<Point3>& points) {
  const auto defect = ConvexPolygon::defect(points);
  EXPECT_TRUE(defect.has_value());
  return defect.value_or(PolygonDefect{}).kind;
}

/// Points of the parabola y = x², which are corners of a convex polygon whatever x is, in the plane spanned by
/// two integer vectors: exactly coplanar.
std::vector<Point3> on_parabola(std::vector<int> xs, const Point3& origin, const Point3& u, const Point3& v) {
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  std::vector<Point3> points;
  for (const int x : xs) {
    const double a = x;
    const double b = a * a;
    points.push_back({origin.x + a * u.x + b * v.x, origin.y + a * u.y + b * v.y, origin.z + a * u.z + b * v.z});
  }
  return points;
}

rc::Gen<Point3> small_vector() {
  return rc::gen::construct<Point3>(rc::gen::inRange(-9, 10), rc::gen::inRange(-9, 10), rc::gen::inRange(-9, 10));
}

bool independent(const Point3& u, const Point3& v) {
  return u.y * v.z != u.z * v.y || u.z * v.x != u.x * v.z || u.x * v.y != u.y * v.x;
}

/// At least 3 points of a parabola in a random plane.
rc::Gen<std::vector<Point3>> convex_points() {
  return rc::gen::exec([] {
    const auto xs = *rc::gen::suchThat(rc::gen::unique<std::vector<int>>(rc::gen::inRange(-30, 31)),
                                       [](const auto& list) { return list.size() >= 3; });
    const auto [u, v] = *rc::gen::suchThat(rc::gen::pair(small_vector(), small_vector()),
                                           [](const auto& pair) { return independent(pair.first, pair.second); });
    return on_parabola(xs, *small_vector(), u, v);
  });
}

RC_GTEST_PROP(ConvexPolygonProperty, AcceptsPointsOfAParabolaInEitherDirectionAndFromAnyStart, ()) {
  auto points = *convex_points();
  const auto shift = *rc::gen::inRange<std::size_t>(0, points.size());
  std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(shift), points.end());
  if (*rc::gen::arbitrary<bool>()) std::reverse(points.begin(), points.end());
  RC_ASSERT(!ConvexPolygon::defect(points));
  const ConvexPolygon polygon = ConvexPolygon::from_points(points);
  RC_ASSERT(polygon.corners().size() == points.size());
  RC_ASSERT(polygon.is_flat());
}

RC_GTEST_PROP(ConvexPolygonProperty, ASwapOfTwoCornersIsRefusedUnlessItKeepsTheRing, ()) {
  const auto points = *convex_points();
  const std::size_t n = points.size();
  RC_PRE(n >= 5u);
  const auto i = *rc::gen::inRange<std::size_t>(0, n);
  const auto step = *rc::gen::inRange<std::size_t>(1, n);
  auto swapped = points;
  std::swap(swapped[i], swapped[(i + step) % n]);
  const auto defect = ConvexPolygon::defect(swapped);
  RC_ASSERT(defect.has_value());
  RC_ASSERT(defect->kind == Kind::not_convex || defect->kind == Kind::self_crossing);
}

RC_GTEST_PROP(ConvexPolygonProperty, MidpointsOfSidesAreKeptAndAreNoCorners, ()) {
  const auto corners = *convex_points();
  std::vector<Point3> points;
  std::vector<std::uint32_t> expected;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point3& p = corners[i];
    const Point3& q = corners[(i + 1) % corners.size()];
    expected.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(p);
    if (*rc::gen::arbitrary<bool>()) points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
  }
  const auto shift = *rc::gen::inRange<std::size_t>(0, points.size());
  std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(shift), points.end());
  for (auto& e : expected) e = static_cast<std::uint32_t>((e + points.size() - shift) % points.size());
  std::sort(expected.begin(), expected.end());

  const ConvexPolygon polygon = ConvexPolygon::from_points(points);
  RC_ASSERT(std::equal(expected.begin(), expected.end(), polygon.corners().begin(), polygon.corners().end()));
  for (std::uint32_t k = 0; k < expected.size(); ++k) {
    const std::uint32_t end = expected[(k + 1) % expected.size()];
    std::uint32_t lowest_edge = expected[k];
    std::uint32_t lowest_vertex = end;
    for (std::uint32_t v = expected[k]; v != end; v = static_cast<std::uint32_t>((v + 1) % points.size())) {
      lowest_edge = std::min(lowest_edge, v);
      lowest_vertex = std::min(lowest_vertex, v);
    }
    RC_ASSERT(polygon.side_edge(k) == lowest_edge);
    RC_ASSERT(polygon.side_lowest_vertex(k) == lowest_vertex);
  }
}

RC_GTEST_PROP(ConvexPolygonProperty, PushingACornerInwardsIsRefusedAtACorner, ()) {
  // The points 0 to n - 1 of a parabola; the middle one goes beyond the chord of its neighbours.
  const int n = *rc::gen::inRange(5, 40);
  std::vector<int> xs(static_cast<std::size_t>(n));
  std::iota(xs.begin(), xs.end(), 0);
  auto points = on_parabola(xs, {0, 0, 7}, {1, 0, 0}, {0, 1, 0});
  const auto i = *rc::gen::inRange<std::size_t>(1, points.size() - 1);
  points[i].y += 1.5;
  const auto defect = ConvexPolygon::defect(points);
  RC_ASSERT(defect.has_value());
  RC_ASSERT(defect->kind == Kind::not_convex);
  RC_ASSERT(defect->vertex == i);
}

RC_GTEST_PROP(ConvexPolygonProperty, ScalingByAPowerOfTwoChangesNothing, ()) {
  auto points = *convex_points();
  const int exponent = *rc::gen::inRange(-1060, 1000);
  const auto lifted = *rc::gen::inRange<std::size_t>(0, points.size());
  points[lifted].z += *rc::gen::element(0.0, 0x1p-40, 0x1p-20);
  auto scaled = points;
  for (Point3& p : scaled) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  RC_PRE(std::ldexp(scaled[lifted].z, -exponent) == points[lifted].z);
  const auto defect = ConvexPolygon::defect(points);
  const auto defect_of_scaled = ConvexPolygon::defect(scaled);
  RC_ASSERT(defect.has_value() == defect_of_scaled.has_value());
  if (!defect) return;
  RC_ASSERT(defect->kind == defect_of_scaled->kind);
  RC_ASSERT(defect->vertex == defect_of_scaled->vertex);
}

TEST(ConvexPolygon, NamesTheFirstRepeatedVertexAndItsOriginal) {
  auto points = unit_square();
  points.push_back(points[1]);
  const auto defect = ConvexPolygon::defect(points);
  ASSERT_TRUE(defect);
  EXPECT_EQ(defect->kind, Kind::repeated_vertex);
  EXPECT_EQ(defect->vertex, 4u);
  EXPECT_EQ(defect->other, 1u);
}

TEST(ConvexPolygon, TakesMinusZeroForZero) {
  EXPECT_EQ(kind({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {-0.0, -0.0, 1}}), Kind::repeated_vertex);
}

TEST(ConvexPolygon, RefusesFewerThanThreeVertices) {
  EXPECT_EQ(kind({}), Kind::too_few_vertices);
  EXPECT_EQ(kind({{0, 0, 0}, {1, 0, 0}}), Kind::too_few_vertices);
}

TEST(ConvexPolygon, RefusesVerticesOnOneLine) {
  EXPECT_EQ(kind({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {-3, -6, -9}}), Kind::collinear);
}

TEST(ConvexPolygon, AcceptsATriangleOneUlpOffALine) {
  const double above = std::nextafter(2.0, 3.0);
  const auto polygon = ConvexPolygon::from_points({{0, 0, 0}, {1, 1, 1}, {2, 2, above}});
  EXPECT_EQ(polygon.corners().size(), 3u);
}

TEST(ConvexPolygon, RefusesTheStarOrderOfAPentagon) {
  EXPECT_EQ(kind({{0, -10, 1}, {6, 8, 1}, {-10, -3, 1}, {10, -3, 1}, {-6, 8, 1}}), Kind::self_crossing);
}

TEST(ConvexPolygon, RefusesATriangleThatGoesRoundTwice) {
  EXPECT_EQ(kind({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {1, 1, 0}, {9, 1, 0}, {1, 9, 0}}), Kind::self_crossing);
  EXPECT_EQ(kind({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, -1, 0}, {9, -1, 0}, {-1, 9, 0}}), Kind::self_crossing);
}

TEST(ConvexPolygon, RefusesSpikes) {
  EXPECT_TRUE(ConvexPolygon::defect(std::vector<Point3>{{0, 0, 1}, {4, 0, 1}, {2, 0, 1}, {0, 2, 1}}));
  EXPECT_TRUE(ConvexPolygon::defect(std::vector<Point3>{{0, 0, 1}, {2, 0, 1}, {0, 2, 1}, {0, -1, 1}}));
  EXPECT_TRUE(ConvexPolygon::defect(
      std::vector<Point3>{{-4, 0, 1}, {0, 0, 1}, {2, 0, 1}, {0, 2, 1}, {0, 0.5, 1}, {0, 0.25, 1}}));
}

TEST(ConvexPolygon, NamesTheVertexWhereAConcaveBoundaryTurnsTheOtherWay) {
  const auto defect = ConvexPolygon::defect(std::vector<Point3>{{0, 0, 1}, {4, 0, 1}, {1, 1, 1}, {0, 4, 1}});
  ASSERT_TRUE(defect);
  EXPECT_EQ(defect->kind, Kind::not_convex);
  EXPECT_EQ(defect->vertex, 2u);
}

TEST(ConvexPolygon, DecidesConvexityByOneUlp) {
  const double below = std::nextafter(0.5, 0.0);
  const double above = std::nextafter(0.5, 1.0);
  const auto kite = [](double bend) { return std::vector<Point3>{{0, 0, 1}, {1, 0, 1}, {bend, bend, 1}, {0, 1, 1}}; };
  EXPECT_EQ(kind(kite(below)), Kind::not_convex);
  EXPECT_EQ(ConvexPolygon::from_points(kite(0.5)).corners().size(), 3u);
  EXPECT_EQ(ConvexPolygon::from_points(kite(above)).corners().size(), 4u);
}

TEST(ConvexPolygon, NamesSidesOfSeveralEdgesByTheirLowestIndices) {
  // Corners 1, 3, 4; the side from 4 to 1 runs past vertex 0, the one from 1 to 3 past vertex 2.
  const auto polygon = ConvexPolygon::from_points({{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}, {0, 0, 0}});
  EXPECT_THAT(polygon.corners(), ElementsAre(1, 3, 4));
  EXPECT_EQ(polygon.side_edge(0), 1u);
  EXPECT_EQ(polygon.side_edge(1), 3u);
  EXPECT_EQ(polygon.side_edge(2), 0u);
  EXPECT_EQ(polygon.side_lowest_vertex(0), 1u);
  EXPECT_EQ(polygon.side_lowest_vertex(1), 3u);
  EXPECT_EQ(polygon.side_lowest_vertex(2), 0u);
}

TEST(ConvexPolygonRounded, KnowsItsDeviation) {
  auto points = unit_square();
  points[3].z += 0x1p-40;
  const auto polygon = ConvexPolygon::from_points(points);
  EXPECT_FALSE(polygon.is_flat());
  EXPECT_NEAR(polygon.deviation() / 0x1p-40, 1, 1e-12);
}

TEST(ConvexPolygonRounded, AcceptsUpToABillionthOfTheDiameterAndNoMore) {
  // A square of side 3 and 4 has the diameter 5: the limit is the double next below or above 5e-9.
  const auto lifted = [](double z) { return std::vector<Point3>{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, z}}; };
  // As a number, the double 5e-9 is a little larger than 5 / 10^9.
  const double limit = 5e-9;
  EXPECT_GT(static_cast<long double>(limit) * 1e9L, 5.0L);
  EXPECT_EQ(kind(lifted(limit)), Kind::not_coplanar);
  EXPECT_FALSE(ConvexPolygon::defect(lifted(std::nextafter(limit, 0.0))));
  EXPECT_EQ(kind(lifted(1e-8)), Kind::not_coplanar);
}

TEST(ConvexPolygonRounded, NamesTheVertexAndItsDistance) {
  auto points = unit_square();
  points[3].z = 1.5;
  const auto defect = ConvexPolygon::defect(points);
  ASSERT_TRUE(defect);
  EXPECT_EQ(defect->kind, Kind::not_coplanar);
  EXPECT_EQ(defect->vertex, 3u);
  EXPECT_NEAR(defect->deviation, 0.5, 1e-12);
}

TEST(ConvexPolygonRounded, IsNotMisledByNearlyCollinearFirstVertices) {
  // The first three vertices are collinear up to rounding, across the plane: their own plane stands upright.
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 1e-16}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const auto defect = ConvexPolygon::defect(points);
  EXPECT_FALSE(defect) << "deviation " << defect->deviation;
}

TEST(ConvexPolygonDegenerate, HugeCoordinatesWhoseDifferencesOverflow) {
  const double huge = std::numeric_limits<double>::max();
  const auto polygon =
      ConvexPolygon::from_points({{-huge, -huge, huge}, {huge, -huge, huge}, {huge, huge, huge}, {-huge, huge, huge}});
  EXPECT_EQ(polygon.corners().size(), 4u);
  EXPECT_TRUE(polygon.is_flat());
  EXPECT_EQ(kind({{-huge, -huge, huge}, {huge, -huge, huge}, {huge, huge, huge}, {-huge, huge, -huge}}),
            Kind::not_coplanar);
}

TEST(ConvexPolygonDegenerate, SubnormalCoordinates) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const auto polygon = ConvexPolygon::from_points({{0, 0, 0}, {tiny, 0, 0}, {tiny, tiny, 0}, {0, tiny, 0}});
  EXPECT_EQ(polygon.corners().size(), 4u);
  EXPECT_EQ(kind({{0, 0, 0}, {tiny, 0, 0}, {tiny, tiny, 0}, {0, tiny, tiny}}), Kind::not_coplanar);
}

TEST(ConvexPolygonDegenerate, ADeviationBelowEveryDoubleIsNotZero) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  // A steep plane: the vertical error of one smallest double is a distance of a thousandth of it.
  const auto polygon = ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 1000}, {1, 1, 1000}, {0, 1, tiny}});
  EXPECT_FALSE(polygon.is_flat());
  EXPECT_GT(polygon.deviation(), 0);
}

TEST(ConvexPolygonDegenerate, TenThousandVerticesInATiltedPlane) {
  std::vector<int> xs(10000);
  std::iota(xs.begin(), xs.end(), -5000);
  const auto polygon = ConvexPolygon::from_points(on_parabola(xs, {1, 2, 3}, {1, 2, 3}, {3, -1, 2}));
  EXPECT_EQ(polygon.corners().size(), 10000u);
  EXPECT_TRUE(polygon.is_flat());
}

TEST(ConvexPolygonDegenerate, TenThousandRoundedVerticesOfACircle) {
  std::vector<Point3> points;
  for (int i = 0; i < 10000; ++i) {
    const double angle = i * 6.283185307179586 / 10000;
    points.push_back({std::cos(angle), std::sin(angle), std::cos(angle) * 0.3 + std::sin(angle) * 0.7});
  }
  const auto polygon = ConvexPolygon::from_points(points);
  EXPECT_FALSE(polygon.is_flat());
  EXPECT_LT(polygon.deviation(), 1e-15);
}

TEST(ConvexPolygon, ThrowsOnBrokenRequirements) {
  EXPECT_THROW(ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}}), PreconditionError);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(ConvexPolygon::defect(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, infinite, 0}}), PreconditionError);
}

}  // namespace
}  // namespace gnomon
