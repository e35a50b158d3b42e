#include <gtest/gtest.h>

#include "apps/proof/laws/cone.h"
#include "apps/proof/laws/definition.h"
#include "apps/proof/laws/enumeration.h"
#include "apps/proof/laws/visibility_definition.h"
#include "gnomon/errors.h"

namespace gnomon::laws {
namespace {

ConvexPolygon polygon(std::vector<Point3> points) {
  return ConvexPolygon::from_points(std::move(points));
}

/// The rectangle [x0, x1] x [y0, y1] at height z; its front is below.
ConvexPolygon facing_down(double x0, double x1, double y0, double y1, double z) {
  return polygon({{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}});
}

Light lamp(double half_width, double z) {
  return AreaLight{facing_down(-half_width, half_width, -half_width, half_width, z)};
}

ConvexPolygon table(double half_width) {
  return facing_down(-half_width, half_width, -half_width, half_width, 1);
}

ExactVector at(int x, int y, int z) {
  return {Rational(x), Rational(y), Rational(z)};
}

TEST(VisibleFraction, OfASquareIsTheShareOfItsAreaBesideTheBlockersCone) {
  const Light light = AreaLight{facing_down(0, 4, 0, 4, 4)};
  EXPECT_EQ(visible_fraction(light, facing_down(0, 1, 0, 2, 2), at(0, 0, 0)), Rational(1, 2));
  EXPECT_EQ(visible_fraction(light, facing_down(0, 1, 0, 1, 2), at(0, 0, 0)), Rational(3, 4));
  EXPECT_EQ(visible_fraction(light, facing_down(0, 2, 0, 2, 2), at(0, 0, 0)), Rational(0));
  EXPECT_EQ(visible_fraction(light, facing_down(-2, 0, 0, 2, 2), at(0, 0, 0)), Rational(1));
  const ConvexPolygon triangle = polygon({{0, 0, 2}, {2, 0, 2}, {0, 2, 2}});
  EXPECT_EQ(visible_fraction(light, triangle, at(0, 0, 0)), Rational(1, 2));
}

TEST(VisibleFraction, IsNothingBehindAOneSidedLightAndInItsPlane) {
  const ConvexPolygon blocker = table(1);
  EXPECT_FALSE(visible_fraction(lamp(1, 3), blocker, at(0, 0, 4)));
  EXPECT_FALSE(visible_fraction(lamp(1, 3), blocker, at(9, 0, 3)));
  const Light both = AreaLight{facing_down(-1, 1, -1, 1, 3), true};
  EXPECT_EQ(visible_fraction(both, blocker, at(0, 0, 4)), Rational(1));
  EXPECT_FALSE(visible_fraction(both, blocker, at(9, 0, 3)));
}

TEST(VisibleFraction, OfASegmentIsTheShareOfItsLength) {
  const Light light = LinearLight{{0, 0, 2}, {4, 0, 2}};
  EXPECT_EQ(visible_fraction(light, table(1), at(0, 0, 0)), Rational(1, 2));
  EXPECT_EQ(visible_fraction(light, table(1), at(-1, 0, 0)), Rational(1, 4));
  EXPECT_EQ(visible_fraction(light, facing_down(-1, 1, 1, 2, 1), at(0, 0, 0)), Rational(1));
}

TEST(VisibleFraction, CountsABlockerEdgeCoplanarWithASegmentAsHiding) {
  const Light light = LinearLight{{0, 0, 2}, {4, 0, 2}};
  EXPECT_EQ(visible_fraction(light, facing_down(-1, 1, 0, 1, 1), at(0, 0, 0)), Rational(1, 2));
}

TEST(VisibleFraction, OfAPointIsZeroOnGrazingContact) {
  const Light light = PointLight{{0, 0, 2}};
  EXPECT_EQ(visible_fraction(light, table(1), at(2, 0, 0)), Rational(0));
  EXPECT_EQ(visible_fraction(light, table(1), at(2, 2, 0)), Rational(0));
  EXPECT_EQ(visible_fraction(light, table(1), at(3, 0, 0)), Rational(1));
  EXPECT_EQ(visible_fraction(light, table(1), at(0, 0, 3)), Rational(1));
}

TEST(VisibleFraction, IsOneOnTheBlockerAndForALightFlushWithIt) {
  EXPECT_EQ(visible_fraction(PointLight{{0, 0, 2}}, table(1), at(0, 0, 1)), Rational(1));
  EXPECT_EQ(visible_fraction(lamp(1, 1), table(2), at(0, 0, 0)), Rational(1));
  EXPECT_THROW(visible_fraction(PointLight{{5, 0, 1}}, table(1), at(0, 0, 1)), PreconditionError);
}

TEST(VisibleFraction, CountsTheFarSideOfACrossedBlockerPlaneOnly) {
  const Light light = LinearLight{{0, 0, -1}, {0, 0, 3}};
  EXPECT_EQ(visible_fraction(light, table(1), at(1, 0, 0)), Rational(1, 2));
}

TEST(VisibleLengthShare, IsNothingForAPointOfTheLightInAFacet) {
  // The point is halfway between the two walls that the light crosses.
  const Walls box = walls(
      ConvexSolid::hull_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}}));
  EXPECT_EQ(visible_length_share(at(1, 0, -2), at(1, 0, 4), {box}, at(1, 0, 1)), Rational(0));
}

TEST(SegmentMeets, IncludesEndsAndBoundary) {
  EXPECT_TRUE(segment_meets(at(0, 0, 0), at(0, 0, 2), table(1)));
  EXPECT_TRUE(segment_meets(at(2, 0, 0), at(0, 0, 2), table(1)));
  EXPECT_TRUE(segment_meets(at(1, 1, 1), at(0, 0, 2), table(1)));
  EXPECT_FALSE(segment_meets(at(2, 1, 1), at(0, 0, 2), table(1)));
  EXPECT_FALSE(segment_meets(at(0, 0, 3), at(0, 0, 2), table(1)));
}

TEST(StandsApart, NeedsTheBlockerInFrontAndTheLightOnOneSide) {
  EXPECT_TRUE(stands_apart(lamp(1, 3), table(1)));
  EXPECT_FALSE(stands_apart(lamp(1, 1), table(1)));
  EXPECT_FALSE(stands_apart(lamp(1, 0), table(1)));
  EXPECT_TRUE(stands_apart(AreaLight{facing_down(-1, 1, -1, 1, 0), true}, table(1)));
  EXPECT_FALSE(stands_apart(LinearLight{{0, 0, 0}, {0, 0, 2}}, table(1)));
  EXPECT_FALSE(stands_apart(AreaLight{polygon({{0, 0, 2}, {1, 0, 2}, {1, 0, 3}})}, table(1)));
}

TEST(Cone, HoldsWhatItsGeneratorsAddUpTo) {
  const std::vector<ExactColumn> quadrant = {{1, 0}, {0, 1}};
  EXPECT_TRUE(is_in_cone(quadrant, {3, 4}));
  EXPECT_TRUE(is_in_cone(quadrant, {0, 4}));
  EXPECT_TRUE(is_in_cone(quadrant, {0, 0}));
  EXPECT_FALSE(is_in_cone(quadrant, {-1, 4}));
  EXPECT_TRUE(is_in_cone({{1, 1}, {-1, 1}, {0, -1}}, {-5, -7}));
  EXPECT_FALSE(is_in_cone({{1, 1}, {2, 2}}, {-1, -1}));
  EXPECT_FALSE(is_in_cone({{1, 1}, {2, 2}}, {1, 2}));
}

TEST(DifferenceCone, IsTheShadowOfAPointLight) {
  const std::vector<ExactVector> light = {at(0, 0, 2)};
  const std::vector<ExactVector> blocker = exact(table(1).points());
  for (const auto& set : {is_in_difference_cone, is_in_hull_of_vertex_shadows}) {
    EXPECT_TRUE(set(at(0, 0, 0), light, blocker));
    EXPECT_TRUE(set(at(2, 2, 0), light, blocker));
    EXPECT_TRUE(set(at(1, 1, 1), light, blocker));
    EXPECT_FALSE(set(at(3, 0, 0), light, blocker));
    EXPECT_FALSE(set(at(2, 1, 1), light, blocker));
    EXPECT_FALSE(set(at(0, 0, 2), light, blocker));
  }
}

TEST(ParallelRays, MeetABlockerNotNarrowerThanTheLight) {
  const auto rays = [](double light, double blocker) {
    return rays_meet_blocker_in_parallel(vertices(lamp(light, 3)), exact(table(blocker).points()));
  };
  EXPECT_TRUE(rays(1, 2));
  EXPECT_TRUE(rays(1, 1));
  EXPECT_FALSE(rays(2, 1));
}

TEST(ParallelRays, CanBeHeldToAPlane) {
  const std::vector<ExactVector> light = {at(-1, 0, 2), at(1, 0, 2)};
  const ExactPlane through_light = plane_through(at(-1, 0, 2), at(1, 0, 2), at(0, 1, 1));
  const ExactPlane beside = plane_through(at(-1, 0, 2), at(1, 0, 2), at(0, 3, 1));
  const std::vector<ExactVector> blocker = exact(table(2).points());
  EXPECT_TRUE(rays_meet_blocker_in_parallel(light, blocker, through_light));
  EXPECT_FALSE(rays_meet_blocker_in_parallel(light, blocker, beside));
}

TEST(EnumeratedPlanes, OfAlignedSquaresAreFourAndOfTurnedOnesEight) {
  const PlaneCounts aligned = plane_counts(lamp(1, 3), table(1));
  EXPECT_EQ(aligned.coplanar_pairs, 4u);
  const ExtremalPlanes planes = enumerated_planes(lamp(1, 3), table(1));
  EXPECT_EQ(planes.separating_blocker.size(), 4u);
  EXPECT_EQ(planes.separating_light.size(), 0u);
  EXPECT_EQ(planes.supporting_blocker.size(), 4u);
  const ConvexPolygon turned = polygon({{0, -1, 1}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}});
  EXPECT_EQ(plane_counts(lamp(1, 3), turned).coplanar_pairs, 0u);
  EXPECT_EQ(enumerated_planes(lamp(1, 3), turned).separating_light.size(), 4u);
}

TEST(EnumeratedPlanes, NameTheTouchingVerticesOfLowestIndex) {
  // Edge 0 of the table is x = -1. The lamp's vertices 0 and 1 are on that side, 2 and 3 on the other.
  const ExtremalPlanes planes = enumerated_planes(lamp(1, 3), table(1));
  EXPECT_EQ(planes.supporting_blocker[0], (BlockerPlane{BlockerEdge{0}, LightVertex{0}}));
  EXPECT_EQ(planes.separating_blocker[0], (BlockerPlane{BlockerEdge{0}, LightVertex{2}}));
  EXPECT_EQ(planes.separating_blocker[3], (BlockerPlane{BlockerEdge{3}, LightVertex{1}}));
}

TEST(EnumeratedPlanes, NameASideByItsLowestEdgeAlsoAcrossTheLastVertex) {
  // Vertex 0 lies inside a side: edges 4 and 0 make up one side, named 0 and listed last.
  const ConvexPolygon blocker = polygon({{0, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}});
  const std::vector<BlockerPlane> planes = enumerated_planes(PointLight{{0, 0, 2}}, blocker).supporting_blocker;
  ASSERT_EQ(planes.size(), 4u);
  EXPECT_EQ(planes[0].edge, BlockerEdge{1});
  EXPECT_EQ(planes[3].edge, BlockerEdge{0});
}

TEST(EnumeratedPlanes, ThroughALinearLightAreTwoIfItsLineMissesTheBlocker) {
  const auto through_light = [](Point3 start, Point3 end) {
    return enumerated_planes(LinearLight{start, end}, table(1)).separating_light.size();
  };
  EXPECT_EQ(through_light({0, 0, 2}, {1, 2, 2}), 2u);  // both at corners
  EXPECT_EQ(through_light({0, 0, 2}, {1, 0, 2}), 0u);  // both at edges
  EXPECT_EQ(through_light({0, 0, 2}, {0, 0, 3}), 0u);  // the line goes through
  EXPECT_EQ(through_light({1, 1, 2}, {1, 1, 3}), 0u);  // through a corner
}

TEST(PlaneCounts, LeaveOutALinearLightWhoseLineMeetsTheBlocker) {
  const auto light_sides = [](Point3 start, Point3 end) {
    return plane_counts(LinearLight{start, end}, table(1)).light_sides;
  };
  EXPECT_EQ(light_sides({0, 0, 2}, {0, 0, 3}), 0u);
  EXPECT_EQ(light_sides({1, 0, 2}, {1, 0, 3}), 0u);
  EXPECT_EQ(light_sides({1, 1, 2}, {1, 1, 3}), 0u);
  EXPECT_EQ(light_sides({2, 1, 2}, {2, 1, 3}), 2u);
  EXPECT_EQ(light_sides({0, 0, 2}, {1, 0, 2}), 2u);
}

}  // namespace
}  // namespace gnomon::laws
