#include "geometry/scene/convex_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/exact.h"
#include "geometry/scene/polygon_refusal.h"
#include "geometry/spatial/polygon_checks.h"

namespace gnomon {
namespace {

using laws::draw;
using laws::ExactVector;
using laws::once_in;
using testing::ElementsAre;
using testing::SizeIs;
using Points = std::vector<Point3>;

std::vector<std::string> names(const std::vector<ConvexPart>& parts) {
  std::vector<std::string> result;
  for (const ConvexPart& part : parts) result.push_back(part.name);
  return result;
}

std::span<const Point3> points_of(const ConvexBlocker& blocker) {
  return std::visit([](const auto& shape) { return std::span<const Point3>(shape.points()); }, blocker);
}

/// Twice the signed area seen along an axis.
Rational doubled_area(const Points& polygon, int axis) {
  Rational sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 p = projected(polygon[i], axis);
    const Point2 q = projected(polygon[(i + 1) % polygon.size()], axis);
    sum += Rational(p.x) * Rational(q.y) - Rational(p.y) * Rational(q.x);
  }
  return sum;
}

/// Whether a point of the plane lies strictly inside, by the parity of crossings; doubled coordinates keep it off
/// vertices and edges.
bool holds_half_integer_point(const Points& polygon, int axis, const Rational& u, const Rational& v) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 p = projected(polygon[i], axis);
    const Point2 q = projected(polygon[(i + 1) % polygon.size()], axis);
    if ((Rational(p.y) > v) == (Rational(q.y) > v)) continue;
    const Rational x =
        Rational(p.x) + (v - Rational(p.y)) / (Rational(q.y) - Rational(p.y)) * (Rational(q.x) - Rational(p.x));
    if (x > u) inside = !inside;
  }
  return inside;
}

/// A point of a small grid of a tilted plane; nudged off it on demand.
Point3 draw_grid_point(bool rounded) {
  const double u = draw(0, 4), v = draw(0, 4);
  return {u, v, 2 * u - 3 * v + (rounded ? draw(-1, 1) * 0x1p-36 : 0)};
}

/// A simple polygon with many collinear vertices: a triangle into whose edges points were put one after another, where
/// the first fits.
Points draw_polygon(bool rounded) {
  Points polygon = {{0, 0, 0}, {4, 0, 8}, {0, 4, -12}};
  for (int more = draw(0, 9); more > 0; --more) {
    const Point3 p = draw_grid_point(rounded);
    const auto start = std::size_t(draw(0, int(polygon.size()) - 1));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      Points longer = polygon;
      longer.insert(longer.begin() + std::ptrdiff_t((start + i) % polygon.size()), p);
      double deviation = 0;
      if (simple_polygon_refusal(longer, deviation)) continue;
      polygon = longer;
      break;
    }
  }
  if (once_in(2)) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

/// The parts fill the polygon once: their areas add up, all of one sign, and every sampled point of the polygon is in
/// one part and no other point in any.
void check_partition(const Points& polygon) {
  const int axis = polygon_plane(polygon)->dropped_axis;
  const std::vector<ConvexPart> parts = convex_parts({"board", ConcavePolygon{polygon}});
  Rational sum = 0;
  std::vector<Points> pieces;
  for (const ConvexPart& part : parts) {
    Points piece;
    for (const std::uint32_t i : part.vertices) piece.push_back(polygon[i]);
    RC_ASSERT(std::ranges::equal(points_of(part.shape), piece));
    RC_ASSERT(std::holds_alternative<ConvexPolygon>(part.shape) == are_coplanar(piece));
    const Rational area = doubled_area(piece, axis);
    RC_ASSERT(laws::sign(area) == laws::sign(doubled_area(polygon, axis)));
    sum += area;
    pieces.push_back(piece);
  }
  RC_ASSERT(sum == doubled_area(polygon, axis));
  for (int k = 0; k < 10; ++k) {
    const Rational u(3 * draw(-30, 30) + 1, 37);
    const Rational v(3 * draw(-30, 30) + 1, 41);
    const auto holding =
        std::ranges::count_if(pieces, [&](const Points& p) { return holds_half_integer_point(p, axis, u, v); });
    RC_ASSERT(holding == (holds_half_integer_point(polygon, axis, u, v) ? 1 : 0));
  }
}

RC_GTEST_PROP(ConvexPartsAgreement, OfAFlatConcavePolygonFillItOnce, ()) {
  check_partition(draw_polygon(false));
}

RC_GTEST_PROP(ConvexPartsAgreement, OfARoundedConcavePolygonFillItOnceAlongItsAxis, ()) {
  check_partition(draw_polygon(true));
}

TEST(ConvexParts, PolygonIsItselfUnderItsName) {
  const auto parts = convex_parts({"table", ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})});
  EXPECT_THAT(names(parts), ElementsAre("table"));
  EXPECT_THAT(parts[0].vertices, ElementsAre(0, 1, 2));
  EXPECT_TRUE(std::holds_alternative<ConvexPolygon>(parts[0].shape));
}

TEST(ConvexParts, RoundedPolygonIsASolidUnderItsName) {
  const auto parts =
      convex_parts({"leaf", ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1e-12}})});
  EXPECT_THAT(names(parts), ElementsAre("leaf"));
  EXPECT_TRUE(std::holds_alternative<ConvexSolid>(parts[0].shape));
}

TEST(ConvexParts, PolytopeIsTheSolidOfItsPoints) {
  const auto parts = convex_parts({"post", Polytope{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}}});
  EXPECT_THAT(names(parts), ElementsAre("post"));
  EXPECT_THAT(std::get<ConvexSolid>(parts[0].shape).corners(), SizeIs(4));
}

TEST(ConvexParts, OfAnLAreNumbered) {
  const Points l = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  EXPECT_THAT(names(convex_parts({"board", ConcavePolygon{l}})), ElementsAre("board#0", "board#1"));
}

TEST(ConvexParts, OfAConcavePolygonThatIsConvexIsOneNumberedPart) {
  EXPECT_THAT(names(convex_parts({"board", ConcavePolygon{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}}}})),
              ElementsAre("board#0"));
}

/// An L of height 1: its two concave facets are cut in two.
Mesh block_of_l() {
  Mesh mesh{"l.obj", {}, {}, true};
  for (const double z : {0.0, 1.0}) {
    mesh.vertices.insert(mesh.vertices.end(), {{0, 0, z}, {2, 0, z}, {2, 1, z}, {1, 1, z}, {1, 2, z}, {0, 2, z}});
  }
  mesh.facets = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for (std::uint32_t i = 0; i < 6; ++i) mesh.facets.push_back({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  return mesh;
}

TEST(ConvexParts, OfAMeshAreItsFacetsAndPiecesOfConcaveOnes) {
  const auto parts = convex_parts({"vase", block_of_l()});
  EXPECT_THAT(names(parts), ElementsAre("vase#0#0", "vase#0#1", "vase#1#0", "vase#1#1", "vase#2", "vase#3", "vase#4",
                                        "vase#5", "vase#6", "vase#7"));
  EXPECT_THAT(parts[4].vertices, ElementsAre(0, 1, 7, 6));
}

TEST(EnclosedSpace, OfAClosedMeshIsWhatItsFacetsEnclose) {
  const auto space = enclosed_space({"vase", block_of_l()});
  ASSERT_TRUE(space);
  EXPECT_TRUE(is_strictly_inside({0.5, 0.5, 0.5}, *space));
  EXPECT_TRUE(is_strictly_inside({0.5, 1.5, 0.5}, *space));
  EXPECT_TRUE(is_strictly_inside({1.5, 0.5, 0.5}, *space));
  EXPECT_FALSE(is_strictly_inside({1.5, 1.5, 0.5}, *space));
  EXPECT_FALSE(is_strictly_inside({0.5, 0.5, 1}, *space));
}

TEST(EnclosedSpace, OfAnOpenMeshAndOfOtherBlockersIsNothing) {
  Mesh open = block_of_l();
  open.closed = false;
  EXPECT_FALSE(enclosed_space({"vase", open}));
  EXPECT_FALSE(enclosed_space({"post", Polytope{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}));
}

TEST(ConvexPartsDegenerate, AFacetRoundedInAMeshIsASolid) {
  Mesh mesh{"leaf.obj", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1e-12}}, {{0, 1, 2, 3}}, false};
  const auto parts = convex_parts({"leaf", mesh});
  EXPECT_THAT(names(parts), ElementsAre("leaf#0"));
  EXPECT_TRUE(std::holds_alternative<ConvexSolid>(parts[0].shape));
}

TEST(ConvexPartsDegenerate, ASmallPieceOfARoundedPolygonMayBeRoundedInProportionByMore) {
  // A large board with a notch a thousandth as wide, whose corners are 1e-10 off the plane.
  const Points board = {{0, 0, 0},         {1, 0, 0},           {1, 1, 0},   {0.501, 1, 1e-10},
                        {0.501, 0.999, 0}, {0.5, 0.999, 1e-10}, {0.5, 1, 0}, {0, 1, 0}};
  double deviation = 0;
  ASSERT_FALSE(simple_polygon_refusal(board, deviation));
  EXPECT_GE(convex_parts({"board", ConcavePolygon{board}}).size(), 2u);
}

}  // namespace
}  // namespace gnomon
