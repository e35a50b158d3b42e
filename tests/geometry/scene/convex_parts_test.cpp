#include "gnomon/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "apps/proof/laws/draw.h"
#include "apps/proof/laws/exact.h"
#include "geometry/bodies/closed_surface.h"
#include "geometry/bodies/polygon_checks.h"
#include "geometry/scene/polygon_examination.h"

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
      if (repeated_vertex(longer) || examined_polygon(longer, whole_ring(longer.size())).refusal) continue;
      polygon = longer;
      break;
    }
  }
  if (once_in(2)) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

/// The points of a ring.
Points ring_points(const Points& points, const Ring& ring) {
  return points_of_rings(points, {&ring, 1});
}

/// The parts fill the polygon once: their areas add up, all of one sign, and every sampled point of the polygon is in
/// one part and no other point in any.
void check_partition(const ConcavePolygon& polygon, const std::vector<Ring>& rings) {
  const Points& vertices = polygon.vertices;
  const int axis = polygon_plane(points_of_rings(vertices, rings))->dropped_axis;
  const std::vector<ConvexPart> parts = convex_parts({"board", polygon});
  const Rational outer = doubled_area(ring_points(vertices, rings[0]), axis);
  Rational whole = abs(outer), sum = 0;
  for (std::size_t r = 1; r < rings.size(); ++r) whole -= abs(doubled_area(ring_points(vertices, rings[r]), axis));
  std::vector<Points> pieces;
  for (const ConvexPart& part : parts) {
    const Points piece = ring_points(vertices, part.vertices);
    RC_ASSERT(std::ranges::equal(points_of(part.shape), piece));
    RC_ASSERT(std::holds_alternative<ConvexPolygon>(part.shape) == are_coplanar(piece));
    const Rational area = doubled_area(piece, axis);
    RC_ASSERT(laws::sign(area) == laws::sign(outer));
    sum += abs(area);
    pieces.push_back(piece);
  }
  RC_ASSERT(sum == whole);
  for (int k = 0; k < 10; ++k) {
    const Rational u(3 * draw(-30, 30) + 1, 37);
    const Rational v(3 * draw(-30, 30) + 1, 41);
    const auto holding =
        std::ranges::count_if(pieces, [&](const Points& p) { return holds_half_integer_point(p, axis, u, v); });
    const auto around = std::ranges::count_if(
        rings, [&](const Ring& ring) { return holds_half_integer_point(ring_points(vertices, ring), axis, u, v); });
    RC_ASSERT(holding == around % 2);
  }
}

void check_partition(const Points& polygon) {
  check_partition(ConcavePolygon{polygon}, {whole_ring(polygon.size())});
}

/// A polygon on a finer grid with the triangular holes of some tries that fit: anything from a frame to a sieve.
ConcavePolygon draw_polygon_with_holes(bool rounded) {
  ConcavePolygon polygon{draw_polygon(rounded)};
  for (Point3& p : polygon.vertices) p = {4 * p.x, 4 * p.y, 4 * p.z};
  polygon.rings = {whole_ring(polygon.vertices.size())};
  for (int tries = draw(1, 12); tries > 0; --tries) {
    Points vertices = polygon.vertices;
    Ring hole;
    for (int corner = 0; corner < 3; ++corner) {
      hole.push_back(std::uint32_t(vertices.size()));
      const double u = draw(0, 16), v = draw(0, 16);
      vertices.push_back({u, v, 2 * u - 3 * v + (rounded ? draw(-1, 1) * 0x1p-34 : 0)});
    }
    std::vector<Ring> holes(polygon.rings.begin() + 1, polygon.rings.end());
    holes.push_back(hole);
    if (examined_polygon(vertices, polygon.rings[0], holes).refusal) continue;
    polygon.vertices = std::move(vertices);
    polygon.rings.push_back(hole);
  }
  return polygon;
}

/// The same boundary in one ring: to a vertex of each hole along a seam, round it the other way, and back.
Ring ring_with_seams(const ConcavePolygon& polygon) {
  const auto area = [&](const Ring& ring) { return laws::sign(doubled_area(ring_points(polygon.vertices, ring), 2)); };
  Ring ring = polygon.rings[0];
  for (std::size_t r = 1; r < polygon.rings.size(); ++r) {
    Ring hole = polygon.rings[r];
    if (area(hole) == area(polygon.rings[0])) std::reverse(hole.begin(), hole.end());
    const auto at = std::size_t(draw(0, int(polygon.rings[0].size()) - 1));
    const auto place = std::find(ring.begin(), ring.end(), polygon.rings[0][at]);
    Ring detour = hole;
    detour.push_back(hole[0]);
    detour.push_back(*place);
    ring.insert(place + 1, detour.begin(), detour.end());
  }
  return ring;
}

RC_GTEST_PROP(ConvexPartsAgreement, OfAPolygonWithHolesFillItOnce, ()) {
  const ConcavePolygon polygon = draw_polygon_with_holes(once_in(4));
  check_partition(polygon, polygon.rings);
}

RC_GTEST_PROP(ConvexPartsAgreement, OfAFacetWithSeamsAreThoseOfItsRings, ()) {
  const ConcavePolygon polygon = draw_polygon_with_holes(false);
  const Ring facet = ring_with_seams(polygon);
  RC_ASSERT(!examined_polygon(polygon.vertices, facet).refusal);
  const std::vector<ConvexPart> parts = convex_parts({"wall", Mesh{"", polygon.vertices, {facet}, false}});
  std::vector<Ring> of_facet, of_rings;
  for (const ConvexPart& part : parts) of_facet.push_back(part.vertices);
  for (const ConvexPart& part : convex_parts({"wall", polygon})) of_rings.push_back(part.vertices);
  Rational sum = 0;
  for (const Ring& part : of_facet) sum += abs(doubled_area(ring_points(polygon.vertices, part), 2));
  for (const Ring& part : of_rings) sum -= abs(doubled_area(ring_points(polygon.vertices, part), 2));
  RC_ASSERT(sum == 0);
  for (int k = 0; k < 10; ++k) {
    const Rational u(3 * draw(-10, 180) + 1, 37), v(3 * draw(-10, 180) + 1, 41);
    const auto holding = [&](const std::vector<Ring>& pieces) {
      return std::ranges::count_if(pieces, [&](const Ring& piece) {
        return holds_half_integer_point(ring_points(polygon.vertices, piece), 2, u, v);
      });
    };
    RC_ASSERT(holding(of_facet) == holding(of_rings));
  }
}

RC_GTEST_PROP(ConvexPartsAgreement, OfABentPolygonAreTrianglesThatFillItOnce, ()) {
  ConcavePolygon polygon = once_in(2) ? draw_polygon_with_holes(false) : ConcavePolygon{draw_polygon(false)};
  for (Point3& p : polygon.vertices) p.z += draw(-1, 1) * 0x1p-7;
  const std::vector<Ring> rings =
      polygon.rings.empty() ? std::vector<Ring>{whole_ring(polygon.vertices.size())} : polygon.rings;
  const std::vector<Ring> holes(rings.begin() + 1, rings.end());
  const PolygonExamination examined = examined_polygon(polygon.vertices, rings[0], holes);
  RC_PRE(!examined.refusal);
  check_partition(polygon, rings);
  if (examined.plane.flatness != Flatness::bent) return;
  for (const ConvexPart& part : convex_parts({"leaf", polygon})) {
    RC_ASSERT(part.vertices.size() == 3u);
    RC_ASSERT(std::holds_alternative<ConvexPolygon>(part.shape));
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

TEST(ConvexParts, OfABentConvexPolygonAreTheFanFromItsFirstVertex) {
  const Points roof = {{0, 0, 0}, {2, 0, 0}, {3, 1, 0.01}, {2, 2, 0}, {0, 2, 0}};
  for (const bool turned : {false, true}) {
    Points points = roof;
    if (turned) std::reverse(points.begin() + 1, points.end());
    const auto parts = convex_parts({"roof", ConcavePolygon{points}});
    EXPECT_THAT(names(parts), ElementsAre("roof#0", "roof#1", "roof#2"));
    EXPECT_THAT(parts[0].vertices, ElementsAre(0, 1, 2));
    EXPECT_THAT(parts[1].vertices, ElementsAre(0, 2, 3));
    EXPECT_THAT(parts[2].vertices, ElementsAre(0, 3, 4));
  }
}

TEST(ConvexParts, OfABentPolygonWhoseFanIsFlatAgainstItsSideAreDelaunayTriangles) {
  // The first three vertices are on one line: no triangle of a fan that could be seen.
  const Points leaf = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0.01}, {0, 2, 0}};
  const auto parts = convex_parts({"leaf", ConcavePolygon{leaf}});
  EXPECT_THAT(parts, SizeIs(3));
  for (const ConvexPart& part : parts) EXPECT_TRUE(std::holds_alternative<ConvexPolygon>(part.shape));
}

TEST(ConvexParts, OfAWallWithAWindowAreFourAtMost) {
  const ConcavePolygon wall{{{0, 0, 0}, {6, 0, 0}, {6, 0, 3}, {0, 0, 3}, {2, 0, 1}, {4, 0, 1}, {4, 0, 2}, {2, 0, 2}},
                            {{0, 1, 2, 3}, {4, 5, 6, 7}}};
  EXPECT_THAT(convex_parts({"wall", wall}), SizeIs(4));
}

TEST(ConvexParts, OfAMeshHaveTheNumbersOfTheFile) {
  Mesh mesh{"a.obj", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}, false, {3, 7}};
  EXPECT_THAT(names(convex_parts({"leaf", mesh})), ElementsAre("leaf#3", "leaf#7"));
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

TEST(SceneBodies, AreThePartsOfAllBlockersWithTheirNamesAndWhatClosedMeshesEnclose) {
  SpaceScene scene;
  scene.blockers.push_back({"table", ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})});
  scene.blockers.push_back({"vase", block_of_l()});
  const SceneBodies bodies = scene_bodies(scene);
  ASSERT_EQ(bodies.names.size(), 11U);
  EXPECT_EQ(bodies.obstacles.blockers.size(), 11U);
  EXPECT_THAT(bodies.names[0], "table");
  EXPECT_THAT(bodies.names[10], "vase#7");
  EXPECT_THAT(bodies.blocker_ids, ElementsAre(0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1));
  EXPECT_EQ(bodies.obstacles.enclosures.size(), 1U);
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
  ASSERT_FALSE(examined_polygon(board, whole_ring(board.size())).refusal);
  EXPECT_GE(convex_parts({"board", ConcavePolygon{board}}).size(), 2u);
}

}  // namespace
}  // namespace gnomon
