#include <gtest/gtest.h>

#include "gnomon/shadow_mesh.h"
#include "gnomon/shadow_volume.h"
#include "gnomon/visibility.h"

// Claims of the papers that fail outside standard position, each with the counterexample built: what the volumes say
// and what points see.
namespace gnomon {
namespace {

AreaLight unit_lamp() {
  return AreaLight{ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})};
}

Visibility seen(const Light& light, const std::vector<ConvexBlocker>& blockers, const Point3& p) {
  return exact_visibility(light, {blockers, {}}, p);
}

TEST(RefutedClaim, ASharedEdgeDoesNotRuleOutAnUmbra) {  // [CF91] 4.2.3
  const Light light = unit_lamp();
  const ConvexBlocker blocker = ConvexPolygon::from_points({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});
  const ShadowVolumes volumes = shadow_volumes(light, blocker);
  EXPECT_FALSE(volumes.umbra_facts.empty);
  EXPECT_EQ(volumes.umbra.oriented_side({-0.1, 0.5, 0.05}), Side::inside);
  for (const double x : {-0.11, -0.1, -0.09}) {
    for (const double z : {0.04, 0.05, 0.06}) {
      EXPECT_EQ(seen(light, {blocker}, {x, 0.5, z}).region, Region::umbra);
    }
  }
  const ShadowMeshes meshes = shadow_meshes(light, blocker, {{-2, -2, -2}, {2, 2, 2}});
  EXPECT_GT(meshes.umbra.volume.nearest, 0);
}

TEST(RefutedClaim, PlanesOfAnEdgeWithASharedVertexBoundTheOcclusion) {  // [CF91] 4.2.2, read literally
  const Light light = unit_lamp();
  const ConvexBlocker blocker = ConvexPolygon::from_points({{0, 0, 0}, {0, 1, 1}, {0, -1, 1}});
  const ShadowVolumes volumes = shadow_volumes(light, blocker);
  EXPECT_EQ(volumes.occlusion.oriented_side({-1, 1, 0.5}), Side::outside);
  EXPECT_EQ(seen(light, {blocker}, {-1, 1, 0.5}).region, Region::lit);
  EXPECT_EQ(volumes.occlusion.oriented_side({-0.5, -0.125, 0.75}), Side::inside);
}

TEST(RefutedClaim, HalvesOfALightThatCrossesTheBlockersPlaneDoNotShareTheirUmbrae) {  // [P93] 4.2.2.1, in space
  const ConvexBlocker blocker = ConvexPolygon::from_points({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  const LinearLight whole{{0, 0, -1}, {0, 0, 1}};
  EXPECT_FALSE(shadow_volumes(LinearLight{{0, 0, 0}, {0, 0, 1}}, blocker).umbra_facts.empty);
  EXPECT_FALSE(shadow_volumes(LinearLight{{0, 0, -1}, {0, 0, 0}}, blocker).umbra_facts.empty);
  const ShadowVolumes volumes = shadow_volumes(whole, blocker);
  EXPECT_TRUE(volumes.umbra_facts.empty);
  EXPECT_EQ(volumes.penumbra_facts.components, 2U);
  EXPECT_EQ(seen(whole, {blocker}, {0.25, 0.25, -0.5}).region, Region::penumbra);
}

TEST(RefutedClaim, ConnectedBlockersDoNotTurnAllOfACommonPenumbraIntoUmbra) {  // [P93] 4.2.2.2, in space
  // Two halves of a board that is shorter than the light: far away neither hides it, nor do both.
  const Light light = LinearLight{{-2, 0, 4}, {2, 0, 4}};
  const ConvexBlocker left = ConvexPolygon::from_points({{-1, -9, 0}, {0, -9, 0}, {0, 9, 0}, {-1, 9, 0}});
  const ConvexBlocker right = ConvexPolygon::from_points({{0, -9, 0}, {1, -9, 0}, {1, 9, 0}, {0, 9, 0}});
  const Point3 far{0, 0, -12};
  EXPECT_EQ(seen(light, {left}, far).region, Region::penumbra);
  EXPECT_EQ(seen(light, {right}, far).region, Region::penumbra);
  EXPECT_EQ(seen(light, {left, right}, far).region, Region::penumbra);
  const Point3 near{0, 0, -1};
  EXPECT_EQ(seen(light, {left}, near).region, Region::penumbra);
  EXPECT_EQ(seen(light, {right}, near).region, Region::penumbra);
  EXPECT_EQ(seen(light, {left, right}, near).region, Region::umbra);
}

TEST(RefutedClaim, TheUmbraOfASolidMayFallIntoSeveralPockets) {  // "at most one umbra", theory S15
  const ConvexBlocker solid = ConvexSolid::hull_of({{1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, -1}});
  const Light light =
      AreaLight{ConvexPolygon::from_points({{-4, -0.25, 1}, {-4, 0.25, 1}, {4, 0.25, 1}, {4, -0.25, 1}})};
  const ShadowVolumes volumes = shadow_volumes(light, solid);
  EXPECT_EQ(volumes.umbra_pockets, 2U);
  for (const double y : {-0.9, 0.9}) {
    EXPECT_EQ(volumes.umbra.oriented_side({0, y, -0.25}), Side::inside);
    EXPECT_EQ(seen(light, {solid}, {0, y, -0.25}).region, Region::umbra);
  }
  for (const double x : {-0.9, -0.4, 0.0, 0.4, 0.9}) {
    for (const double z : {-1.1, -1.01, -2.0}) {
      EXPECT_NE(seen(light, {solid}, {x, 0, z}).region, Region::umbra) << x << ' ' << z;
    }
  }
  const ShadowMeshes meshes = shadow_meshes(light, solid, {{-3, -3, -3}, {3, 3, 2}});
  EXPECT_FALSE(meshes.umbra_pockets.triangles.empty());
}

TEST(RefutedClaim, UnitingTheUmbraeOfPartsMissesTheirJointUmbra) {  // [P93] 5.2.3 applied to umbrae
  const Light light = AreaLight{ConvexPolygon::from_points({{-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4}})};
  const ConvexBlocker left = ConvexPolygon::from_points({{-2, -2, 0}, {0, -2, 0}, {0, 2, 0}, {-2, 2, 0}});
  const ConvexBlocker right = ConvexPolygon::from_points({{0, -2, 0}, {2, -2, 0}, {2, 2, 0}, {0, 2, 0}});
  const Point3 p{0, 0, -1};
  EXPECT_EQ(shadow_volumes(light, left).umbra.oriented_side(p), Side::outside);
  EXPECT_EQ(shadow_volumes(light, right).umbra.oriented_side(p), Side::outside);
  EXPECT_EQ(seen(light, {left, right}, p).region, Region::umbra);
}

}  // namespace
}  // namespace gnomon
