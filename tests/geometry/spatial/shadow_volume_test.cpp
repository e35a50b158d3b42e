#include "gnomon/shadow_volume.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gnomon {
namespace {

Light square_lamp(double half) {
  return AreaLight{
      ConvexPolygon::from_points({{-half, -half, 4}, {-half, half, 4}, {half, half, 4}, {half, -half, 4}})};
}

ConvexPolygon square() {
  return ConvexPolygon::from_points({{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}});
}

TEST(ShadowVolumes, UmbraIsBoundedExactlyWhenTheLampIsLarger) {
  EXPECT_FALSE(shadow_volumes(square_lamp(0.5), square()).umbra_facts.bounded);
  EXPECT_TRUE(shadow_volumes(square_lamp(2), square()).umbra_facts.bounded);
}

TEST(ShadowVolumesDegenerate, UmbraOfEqualSquaresIsAnUnboundedPrism) {
  EXPECT_FALSE(shadow_volumes(square_lamp(1), square()).umbra_facts.bounded);
  EXPECT_TRUE(shadow_volumes(square_lamp(std::nextafter(1.0, 2.0)), square()).umbra_facts.bounded);
}

TEST(ShadowVolumes, SidesOfPointsAreDecidedExactly) {
  const ShadowVolumes shadow = shadow_volumes(square_lamp(2), square());
  EXPECT_EQ(shadow.umbra.oriented_side({0, 0, 0}), Side::boundary);  // the apex
  EXPECT_EQ(shadow.umbra.oriented_side({0, 0, 0x1p-60}), Side::inside);
  EXPECT_EQ(shadow.umbra.oriented_side({0, 0, -0x1p-60}), Side::outside);
  EXPECT_EQ(shadow.umbra.oriented_side({0, 0, 2}), Side::boundary);  // on the blocker
  EXPECT_EQ(shadow.occlusion.oriented_side({0, 0, -9}), Side::inside);
  EXPECT_EQ(shadow.occlusion.oriented_side({0, 0, 3}), Side::outside);
}

TEST(ShadowVolumes, PointLightHasNoPenumbra) {
  const ShadowVolumes shadow = shadow_volumes(PointLight{{0, 0, 4}}, square());
  EXPECT_TRUE(shadow.penumbra_facts.empty);
  EXPECT_EQ(shadow.penumbra_facts.components, 0u);
  EXPECT_FALSE(shadow.umbra_facts.bounded);
}

TEST(ShadowVolumes, PenumbraOfALinearLightFallsInTwoWhereTheUmbraStaysOpenInBothTangentPlanes) {
  const auto components = [](const Point3& start, const Point3& end) {
    return shadow_volumes(LinearLight{start, end}, square()).penumbra_facts.components;
  };
  EXPECT_EQ(components({-1, 0, 4}, {1, 0, 4}), 2u);    // parallel to two edges, no longer than they are
  EXPECT_EQ(components({-3, 0, 4}, {3, 0, 4}), 1u);    // longer: the umbra closes
  EXPECT_EQ(components({-1, 0, 4}, {1, 0.5, 4}), 1u);  // not parallel: the penumbra goes round
  EXPECT_EQ(components({0, 0, 4}, {0, 0, 5}), 1u);     // its line meets the blocker
}

TEST(ShadowVolumesDegenerate, TwoSidedLampShadesWhatIsBehindItToo) {
  Light both = square_lamp(0.5);
  std::get<AreaLight>(both).two_sided = true;
  const ConvexPolygon above = ConvexPolygon::from_points({{-1, -1, 6}, {1, -1, 6}, {1, 1, 6}, {-1, 1, 6}});
  EXPECT_EQ(shadow_volumes(both, above).umbra.oriented_side({0, 0, 9}), Side::inside);
}

}  // namespace
}  // namespace gnomon
