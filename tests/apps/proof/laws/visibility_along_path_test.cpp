#include "apps/proof/laws/visibility_along_path.h"

#include <gtest/gtest.h>

#include "apps/proof/laws/definition.h"

namespace gnomon::laws {
namespace {

ExactVector path_point(int x, int y, int z) {
  return {Rational(x), Rational(y), Rational(z)};
}

ConvexPolygon path_polygon(std::vector<Point3> points) {
  return ConvexPolygon::from_points(std::move(points));
}

const Light triangle_lamp = AreaLight{path_polygon({{-2, 12, -2}, {2, 10, 1}, {0, 14, 1}}), true};

/// Three blockers with edges in line before the lamp, seen from the origin.
std::vector<Walls> three_blockers() {
  return {walls(ConvexSolid::hull_of({{-1, 3, 0}, {1, 3, 0}, {0, 3, 1}, {0, 4, 1}})),
          walls(path_polygon({{-1, 4, 1}, {1, 8, -1}, {-1, 6, -1}, {-3, 2, 1}})),
          walls(path_polygon({{1, 9, 2}, {-1, 9, -2}, {1, 9, 0}}))};
}

/// What the series leaves of the exact share at a distance, divided by its cube.
Rational cubic_rest(const Light& light, const std::vector<Walls>& blockers, const Path& path, const Rational& t) {
  const Jet jet = visible_share_after(light, blockers, path);
  const ExactVector p = path.start + t * path.direction;
  const Rational share = visible_area_share(vertices(light), blockers, p);
  return Rational((share - jet.value - jet.slope * t - jet.bend * t * t) / (t * t * t));
}

TEST(Germ, IsOrderedByItsFirstCoefficient) {
  EXPECT_EQ(Germ({0, 0, -1, 100}).sign(), -1);
  EXPECT_EQ(Germ({1, -100}).sign(), 1);
  EXPECT_EQ(Germ({0, 0}).sign(), 0);
  EXPECT_EQ((Germ({1, 2}) * Germ({3, -1}) - Germ({3, 5})).sign(), -1);
}

TEST(Germ, HasTheQuotientOfItsSeries) {
  // t (1 + t) / (t (2 - t)) = 1/2 + 3/4 t + 3/8 t² + ...
  const Jet jet = quotient(Germ({0, 1, 1}), Germ({0, 2, -1}));
  EXPECT_EQ(jet, (Jet{Rational(1, 2), Rational(3, 4), Rational(3, 8)}));
}

TEST(VisibleShareAfter, LeavesARestOfThirdOrderOfTheExactShare) {
  for (const ExactVector& direction :
       {path_point(-1, -2, 0), path_point(1, 2, 0), path_point(1, 0, 2), path_point(0, 1, -1)}) {
    for (const ExactVector& start : {path_point(0, 0, 0), path_point(1, -1, 0), path_point(0, 0, 1)}) {
      const Path path{start, direction};
      const Rational near = cubic_rest(triangle_lamp, three_blockers(), path, Rational(1, 1 << 20));
      const Rational nearer = cubic_rest(triangle_lamp, three_blockers(), path, Rational(1, 1 << 21));
      EXPECT_LE(abs(Rational(near - nearer)), Rational(1, 1 << 8)) << near << " " << nearer;
    }
  }
}

TEST(VisibleShareAfter, OfASegmentIsTheLengthLeft) {
  // Moving along the light at t, a board half way hides what is beyond 2 - t.
  const Light light = LinearLight{{0, 0, 2}, {4, 0, 2}};
  const std::vector<Walls> board = {walls(path_polygon({{1, -1, 1}, {9, -1, 1}, {9, 1, 1}, {1, 1, 1}}))};
  EXPECT_EQ(visible_share_after(light, board, {path_point(0, 0, 0), path_point(1, 0, 0)}),
            (Jet{Rational(1, 2), Rational(-1, 4), 0}));
}

TEST(VisibleShareAfter, IsTheLimitFromTheFrontOfAReceiver) {
  const Light light = AreaLight{path_polygon({{-1, -1, 3}, {-1, 1, 3}, {1, 1, 3}, {1, -1, 3}})};
  const std::vector<Walls> block = {walls(ConvexSolid::hull_of(
      {{-2, -2, 0}, {2, -2, 0}, {-2, 2, 0}, {2, 2, 0}, {-2, -2, 1}, {2, -2, 1}, {-2, 2, 1}, {2, 2, 1}}))};
  const Path inside{path_point(0, 0, 0), path_point(1, 0, 0), path_point(0, 0, 1)};
  EXPECT_EQ(visible_share_after(light, block, inside).value, 0);
  const Path below{path_point(0, 0, 0), path_point(1, 0, 0), path_point(0, 0, -1)};
  EXPECT_EQ(visible_share_after(light, block, below).value, 0);
  const Path beside{path_point(9, 0, 0), path_point(1, 0, 0), path_point(0, 0, 1)};
  EXPECT_EQ(visible_share_after(light, block, beside).value, 1);
}

TEST(OrderAtStart, IsOneWhereEdgesAreCoplanarAndTwoAtAVertex) {
  const std::vector<ExactVector> lamp = {path_point(-1, -1, 2), path_point(-1, 1, 2), path_point(1, 1, 2),
                                         path_point(1, -1, 2)};
  const std::vector<Walls> square = {walls(path_polygon({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}))};
  EXPECT_EQ(order_at_start(lamp, square, {path_point(-3, 0, 0), path_point(1, 0, 0)}), 1);
  EXPECT_EQ(order_at_start(lamp, square, {path_point(-4, 0, 0), path_point(1, 0, 0)}), std::nullopt);
  const std::vector<Walls> turned = {walls(path_polygon({{0, -1, 1}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}}))};
  EXPECT_EQ(order_at_start(lamp, turned, {path_point(-3, 0, 0), path_point(1, 0, 0)}), 2);
  EXPECT_EQ(
      order_at_start({path_point(0, -1, 2), path_point(0, 1, 2)}, square, {path_point(-2, 0, 0), path_point(1, 0, 0)}),
      0);
}

TEST(SeenPieces, AreTheLightsEdgesAndWhereBlockersEnd) {
  const AreaLight light{path_polygon({{-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}})};
  const auto pieces = [&](const std::vector<Walls>& blockers, const ExactVector& p) {
    return visible_pieces(light, blockers, {p, {}}).size();
  };
  const Walls strip = walls(path_polygon({{-9, -0.25, 1}, {9, -0.25, 1}, {9, 0.25, 1}, {-9, 0.25, 1}}));
  EXPECT_EQ(pieces({}, path_point(0, 0, 0)), 4u);
  EXPECT_EQ(pieces({strip}, path_point(0, 0, 0)), 8u);   // two rectangles
  EXPECT_EQ(pieces({strip}, path_point(0, 20, 0)), 4u);  // beside the strip
  const Walls left = walls(path_polygon({{-9, -1, 1}, {0, -1, 1}, {0, 1, 1}, {-9, 1, 1}}));
  const Walls right = walls(path_polygon({{0, -1, 1}, {9, -1, 1}, {9, 1, 1}, {0, 1, 1}}));
  EXPECT_EQ(pieces({left, right}, path_point(0, 0, 0)), 0u);  // nothing is seen past the joint
}

}  // namespace
}  // namespace gnomon::laws
