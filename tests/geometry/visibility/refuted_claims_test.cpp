#include <gtest/gtest.h>

#include <cmath>

#include "apps/proof/laws/cone.h"
#include "apps/proof/laws/exact.h"
#include "gnomon/visibility.h"

// What the literature says and what is false: the counterexamples, by what points see.

namespace gnomon {
namespace {

ConvexPolygon polygon(std::vector<Point3> points) {
  return ConvexPolygon::from_points(std::move(points));
}

/// The rectangle [x0, x1] x [y0, y1] at height z; its front is above.
ConvexPolygon facing_up(double x0, double x1, double y0, double y1, double z) {
  return polygon({{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}});
}

ConvexPolygon facing_down(double x0, double x1, double y0, double y1, double z) {
  return polygon({{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}});
}

Visibility seen(const Light& light, std::vector<ConvexBlocker> blockers, const Point3& p) {
  return exact_visibility(light, {std::move(blockers), {}}, p);
}

const Light unit_light = AreaLight{facing_up(0, 1, 0, 1, 0)};

TEST(RefutedClaim, F1LightAndBlockerThatShareAnEdgeDoMakeAnUmbra) {
  const ConvexPolygon wall = polygon({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});
  EXPECT_EQ(seen(unit_light, {wall}, {-0.1, 0.5, 0.05}), (Visibility{Region::umbra, 0, 0}));
  // The umbra of one flat blocker is convex: with the corners of a box it holds the box.
  for (const double dx : {-0.01, 0.01}) {
    for (const double dy : {-0.01, 0.01}) {
      for (const double dz : {-0.01, 0.01}) {
        EXPECT_EQ(seen(unit_light, {wall}, {-0.1 + dx, 0.5 + dy, 0.05 + dz}).region, Region::umbra);
      }
    }
  }
}

TEST(RefutedClaim, F2PlanesThroughASharedVertexMayBoundTheOcclusion) {
  const ConvexPolygon triangle = polygon({{0, 0, 0}, {0, 1, 1}, {0, -1, 1}});
  const Point3 p{-1, 1, 0.5};
  EXPECT_EQ(seen(unit_light, {triangle}, p), (Visibility{Region::lit, 1, 0}));
  // The one separating plane of the only edge without the shared vertex is x = 0, and p is on the blocker's side of
  // it: read literally, p would be in the occlusion. In the true one it is not.
  const auto light = laws::exact(std::get<AreaLight>(unit_light).polygon.points());
  const auto blocker = laws::exact(triangle.points());
  const laws::ExactPlane plane = laws::plane_through(blocker[1], blocker[2], light[0]);
  EXPECT_EQ(*laws::common_side(plane, light), -plane.side(laws::exact(p)));
  EXPECT_EQ(*laws::common_side(plane, blocker), 0);
  EXPECT_FALSE(laws::is_in_difference_cone(laws::exact(p), light, blocker));
}

const Light wide_lamp = AreaLight{facing_down(-2, 2, -2, 2, 4)};

TEST(RefutedClaim, F4TheCommonPenumbraOfConnectedBlockersIsNotAllUmbra) {
  const ConvexPolygon left = facing_up(-1, 0, -1, 1, 2);
  const ConvexPolygon right = facing_up(0, 1, -1, 1, 2);
  const Point3 near{0, 0, 1}, far{0, 0, -12};
  for (const Point3& p : {near, far}) {
    EXPECT_EQ(seen(wide_lamp, {left}, p).region, Region::penumbra);
    EXPECT_EQ(seen(wide_lamp, {right}, p).region, Region::penumbra);
  }
  EXPECT_EQ(seen(wide_lamp, {left, right}, near).region, Region::umbra);
  // From 16 below the lamp and 14 below the board, the board of side 2 hides a square of side 16/7 out of 4.
  const Visibility both = seen(wide_lamp, {left, right}, far);
  EXPECT_EQ(both.region, Region::penumbra);
  EXPECT_DOUBLE_EQ(both.fraction, 33.0 / 49);
}

TEST(RefutedClaim, F4AFoldedPairOnOneSideOfItsJointHasNoUmbraThere) {
  const ConvexPolygon flat = facing_up(0, 1, -1, 1, 2);
  const ConvexPolygon folded = polygon({{0, -1, 2}, {0, 1, 2}, {1, 1, 1}, {1, -1, 1}});
  const Point3 p{0.125, 0, 1.5};
  EXPECT_EQ(seen(wide_lamp, {flat}, p).region, Region::penumbra);
  EXPECT_EQ(seen(wide_lamp, {folded}, p).region, Region::penumbra);
  EXPECT_EQ(seen(wide_lamp, {flat, folded}, p).region, Region::penumbra);
}

TEST(RefutedClaim, F5PairsOfBlockersDoNotSuffice) {
  const Light light = AreaLight{facing_down(0, 3, 0, 1, 2)};
  const ConvexPolygon thirds[] = {facing_up(0.75, 1.25, 0.25, 0.75, 1), facing_up(1.25, 1.75, 0.25, 0.75, 1),
                                  facing_up(1.75, 2.25, 0.25, 0.75, 1)};
  const Point3 p{1.5, 0.5, 0};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(seen(light, {thirds[i]}, p).fraction, 2.0 / 3);
    EXPECT_EQ(seen(light, {thirds[i], thirds[(i + 1) % 3]}, p).fraction, 1.0 / 3);
  }
  EXPECT_EQ(seen(light, {thirds[0], thirds[1], thirds[2]}, p), (Visibility{Region::umbra, 0, 0}));
}

TEST(RefutedClaim, F6TheUmbraOfASolidHasPocketsOutsideIt) {
  const ConvexSolid pyramid = ConvexSolid::hull_of({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, -1}});
  const Light strip = AreaLight{facing_down(-4, 4, -0.25, 0.25, 1)};
  for (const double y : {-0.9, 0.9}) EXPECT_EQ(seen(strip, {pyramid}, {0, y, -0.25}).region, Region::umbra);
  // On the plane y = 0, which parts the two, no point outside the pyramid is in umbra: |x| - z > 1 there.
  int tried = 0;
  for (int i = -48; i <= 48; ++i) {
    for (int j = -64; j <= 0; ++j) {
      const double x = i / 16.0, z = j / 16.0;
      if (std::abs(x) - z <= 1) continue;
      ASSERT_NE(seen(strip, {pyramid}, {x, 0, z}).region, Region::umbra) << x << ' ' << z;
      ++tried;
    }
  }
  EXPECT_GT(tried, 4000);
}

TEST(RefutedClaim, F7UnitingTheUmbraeOfConvexPiecesMissesTheirJointUmbra) {
  // An L of two rectangles behind a lamp that is wider than either, but not than the L at its corner.
  const ConvexPolygon along = facing_up(0, 4, 0, 2, 2);
  const ConvexPolygon across = facing_up(0, 2, 2, 4, 2);
  const Light lamp = AreaLight{facing_down(0, 1, 1, 3, 4)};
  const Point3 p{1, 2, 1};
  EXPECT_EQ(seen(lamp, {along}, p).region, Region::penumbra);
  EXPECT_EQ(seen(lamp, {across}, p).region, Region::penumbra);
  EXPECT_EQ(seen(lamp, {along, across}, p).region, Region::umbra);
}

}  // namespace
}  // namespace gnomon
