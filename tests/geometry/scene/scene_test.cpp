#include "gnomon/scene.h"

#include <gtest/gtest.h>

#include <limits>

namespace gnomon {
namespace {

SpaceScene scene_of_points(std::vector<Point3> points) {
  SpaceScene scene;
  for (const Point3& p : points) scene.lights.push_back({"bulb", PointLight{p}});
  return scene;
}

TEST(DefaultClipBox, GrowsTheBoundingBoxByHalfItsDiagonal) {
  // A box of 2, 3 and 6 has the diagonal 7.
  EXPECT_EQ(default_clip_box(scene_of_points({{0, 0, 0}, {2, 3, 6}})), (Box3{{-3.5, -3.5, -3.5}, {5.5, 6.5, 9.5}}));
}

TEST(DefaultClipBox, HoldsLightsBlockersAndReceivers) {
  SpaceScene scene = scene_of_points({{0, 0, 6}});
  scene.lights.push_back({"tube", LinearLight{{0, 0, 5}, {1, 0, 5}}});
  scene.lights.push_back({"sun", DirectionalLight{{1000, 0, -1}}});
  scene.blockers.push_back({"post", Polytope{{{0, 0, 1}, {2, 0, 1}, {0, 1, 1}, {0, 0, 2}}}});
  scene.receivers.push_back({"floor", ConvexPolygon::from_points({{0, 0, 0}, {1, 0, 0}, {1, 3, 0}})});
  EXPECT_EQ(default_clip_box(scene), (Box3{{-3.5, -3.5, -3.5}, {5.5, 6.5, 9.5}}));
}

TEST(DefaultClipBox, OfThePlaneHasNoDepth) {
  PlaneScene scene;
  scene.lights.push_back({"bulb", {{0, 4}}});
  scene.blockers.push_back({"wall", {{0, 0}, {3, 0}}});
  scene.receivers.push_back({"floor", {{1, 1}, {2, 0}}});
  EXPECT_EQ(default_clip_box(scene), (Box3{{-2.5, -2.5, 0}, {5.5, 6.5, 0}}));
}

TEST(DefaultClipBoxDegenerate, FlatSceneGrowsAcrossItsPlane) {
  EXPECT_EQ(default_clip_box(scene_of_points({{0, 0, 1}, {3, 4, 1}})), (Box3{{-2.5, -2.5, -1.5}, {5.5, 6.5, 3.5}}));
}

TEST(DefaultClipBoxDegenerate, NoPointsOrASinglePoint) {
  EXPECT_FALSE(default_clip_box(scene_of_points({})));
  EXPECT_FALSE(default_clip_box(scene_of_points({{1, 2, 3}})));
}

TEST(DefaultClipBoxDegenerate, Overflow) {
  const double huge = std::numeric_limits<double>::max();
  EXPECT_FALSE(default_clip_box(scene_of_points({{-huge, 0, 0}, {huge, 1, 1}})));
  EXPECT_FALSE(default_clip_box(scene_of_points({{0, 0, 0}, {huge, 1, 1}})));
}

TEST(DefaultClipBoxDegenerate, GrowthLostToRounding) {
  EXPECT_FALSE(default_clip_box(scene_of_points({{0, 0, 1e20}, {1, 1, 1e20}})));
}

}  // namespace
}  // namespace gnomon
