#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "apps/proof/report/embree_visibility.h"
#include "apps/proof/report/plain_visibility.h"
#include "apps/proof/report/polygon_set_visibility.h"
#include "apps/proof/report/reflection_peers.h"
#include "apps/proof/report/shapes.h"
#include "apps/proof/report/triangle_scenes.h"
#include "apps/proof/report/truth.h"
#include "apps/proof/report/volume_peers.h"

// The other ways that gnomon is compared with are right themselves, where rounding and sampling let them.
namespace gnomon::report {
namespace {

constexpr Point3 up{0, 0, 1};

class Peers : public testing::TestWithParam<std::size_t> {};

TEST_P(Peers, FindWhatIsTrueOfRandomTriangles) {
  TriangleScene scene = triangle_scene(GetParam());
  scene.points.resize(12);
  PlainVisibility plain(scene.light, scene.blockers);
  EmbreeVisibility embree(scene.light, scene.blockers);
  embree.place(Placing::regular, 64);
  for (const Point3& p : scene.points) {
    const VisibilityTruth truth = visibility_truth(scene.light, {scene.blockers, {}}, p, up, 128);
    const VisibilityAnswer doubles = plain.visible_from(p, up);
    EXPECT_EQ(doubles.region, truth.region);
    EXPECT_NEAR(doubles.fraction, truth.fraction.low, 1e-12);
    EXPECT_NEAR(doubles.irradiance, truth.irradiance.low, 1e-12);
    const VisibilityAnswer set = polygon_set_visibility(scene.light, scene.blockers, p, up);
    EXPECT_EQ(set.region, truth.region);
    EXPECT_NEAR(set.fraction, truth.fraction.low, 1e-15);
    EXPECT_NEAR(set.irradiance, truth.irradiance.low, 1e-12);
    const VisibilityAnswer rays = embree.visible_from(p, up);
    EXPECT_NEAR(rays.fraction, truth.fraction.low, 0.05);
    EXPECT_NEAR(rays.irradiance, truth.irradiance.low, 0.005);
  }
}

INSTANTIATE_TEST_SUITE_P(Triangles, Peers, testing::Values(1, 4, 16));

TEST(PlainVisibility, SeesASolidAndABlockerAcrossTheLightAsTheDefinitionDoes) {
  const AreaLight lamp = square_light(1, 4);
  const std::vector<ConvexBlocker> blockers = {ConvexSolid::hull_of(turned_cube({0.5, 0.25, 1.75}, 0.7)),
                                               blade(0, -0.5, 0.5, 3, 5)};
  PlainVisibility plain(lamp, blockers);
  for (const Point3& p :
       {Point3{2, 1, 0}, Point3{-3, 0.5, -1}, Point3{0.25, 0.1, -2}, Point3{9, 9, 0}, Point3{0, 0, 5}}) {
    const VisibilityTruth truth = visibility_truth(lamp, {blockers, {}}, p, up, 128);
    const VisibilityAnswer doubles = plain.visible_from(p, up);
    EXPECT_EQ(doubles.region, truth.region);
    EXPECT_NEAR(doubles.fraction, truth.fraction.low, 1e-12);
  }
}

TEST(EmbreeVisibility, PlacesTheSamePointsForTheSameSeed) {
  const TriangleScene scene = triangle_scene(16);
  EmbreeVisibility embree(scene.light, scene.blockers);
  for (const Placing placing : {Placing::regular, Placing::jittered, Placing::stratified}) {
    embree.place(placing, 8);
    const double first = embree.visible_from(scene.points[0], up).irradiance;
    const double next = embree.visible_from(scene.points[0], up).irradiance;
    embree.place(placing, 8);
    EXPECT_EQ(embree.visible_from(scene.points[0], up).irradiance, first);
    EXPECT_EQ(next == first, placing != Placing::stratified);
  }
}

TEST(VolumePeers, HaveTheVolumesOfAlignedSquares) {
  // Below the squares of half sides 1 (at 4) and 2 (at 2) the occlusion widens by 3/2 of the depth, the umbra by 1/2.
  const auto frustum = [](double half_top, double half_bottom, double depth) {
    return 4 * depth / 3 * (half_top * half_top + half_top * half_bottom + half_bottom * half_bottom);
  };
  EXPECT_NEAR(volume_of_vertex_shadow_hull(aligned_squares()), frustum(2, 2 + 9, 6), 1e-9);
  EXPECT_NEAR(volume_of_nef_umbra(aligned_squares()), frustum(2, 2 + 3, 6), 1e-9);
}

/// More points come nearer and nearer, so both are right, or wrong in the same way.
TEST(ReflectionPeers, ComeToWhatGnomonTells) {
  std::map<std::string, std::size_t> points;
  for (const Timing& timing : reflection_peers(Effort::quick)) points[timing.task] = timing.size;
  for (const std::string task : {"penumbra_tube", "penumbra_tube_lobe", "penumbra_lamp_lobe"}) {
    EXPECT_EQ(points[task], 1U) << task;
    EXPECT_GT(points[task + "_at_256"], 40U) << task;
    EXPECT_LT(points[task + "_at_256"], 2048U) << task;
  }
  EXPECT_GT(points["penumbra_tube_lobe_at_1000"], points["penumbra_tube_lobe_at_256"]);
  EXPECT_GT(points["open_tube_lobe_at_10000"], 20U);
  EXPECT_LT(points["open_tube_lobe_at_10000"], 100U);
}

}  // namespace
}  // namespace gnomon::report
