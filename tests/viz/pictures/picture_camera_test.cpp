#include "viz/pictures/picture_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/viz/sample_result.h"
#include "viz/pictures/picture_items.h"
#include "viz/pictures/picture_selection.h"
#include "viz/vtk/block.h"
#include "viz/vtk/vector.h"

namespace gnomon::viz {
namespace {

PictureSource source_of(const Scene& scene) {
  return selected(picture_source(ShadowResult{&scene, *default_clip_box(scene), {}}), {}, LightsShown::first);
}

/// The sample's scene under another light.
Scene scene_under(const Light& light) {
  const SampleResult sample;
  auto scene = std::get<SpaceScene>(*sample.result().scene);
  scene.lights = {{"light", light}};
  return scene;
}

PictureView view_of(const Scene& scene) {
  return picture_view(picture_scene(source_of(scene)), CameraPreset::three_quarter, {640, 480});
}

TEST(PictureCamera, HasZUpWhereverTheLightStands) {
  for (const Point3& place : {Point3{0, 0, 9}, Point3{9, 0, 1}, Point3{0, -9, 1}, Point3{0, 0, -9}}) {
    EXPECT_EQ(view_of(scene_under(PointLight{place})).up, (Point3{0, 0, 1}));
  }
}

TEST(PictureCamera, HasYUpWhereTheSceneSaysSo) {
  Scene scene = scene_under(PointLight{{0, 0, 9}});
  std::get<SpaceScene>(scene).up = UpAxis::y;
  const PictureView view = view_of(scene);
  EXPECT_EQ(view.up, (Point3{0, 1, 0}));
  EXPECT_GT(view.position.y, view.focus.y);
}

TEST(PictureCamera, FramesTheSameUnderASunFromAnywhere) {
  const PictureView above = view_of(scene_under(DirectionalLight{{0, 0, -1}}));
  for (const Point3& direction : {Point3{1, 0, -0.01}, Point3{-3, 2, -1}, Point3{0, 0, 1}}) {
    const PictureView view = view_of(scene_under(DirectionalLight{direction}));
    EXPECT_EQ(view.position, above.position);
    EXPECT_EQ(view.focus, above.focus);
  }
}

TEST(PictureCamera, LeavesTheSizeOfASceneToWhatHasAPlace) {
  const PictureScene scene = picture_scene(source_of(scene_under(DirectionalLight{{1, 0, -0.01}})));
  EXPECT_EQ(scene.suns.size(), 1);
  EXPECT_TRUE(scene.lights.empty());
  Scene without = scene_under(PointLight{{0, 0, 1}});
  EXPECT_EQ(scene.size, picture_scene(source_of(without)).size);
}

TEST(SceneBlocks, HoldASunAsAShortArrowBesideTheScene) {
  for (const Point3& direction : {Point3{0, 0, -1}, Point3{3, 0, -4}, Point3{-1e-9, 0, -1}, Point3{2, 2, 1}}) {
    const Scene scene = scene_under(DirectionalLight{direction});
    for (const Block& block : shadow_blocks(ShadowResult{&scene, *default_clip_box(scene), {}})) {
      if (block.kind != "light") continue;
      const std::vector<Point3> points = points_of(*vtkPolyData::SafeDownCast(block.data));
      const Point3 shaft = points.at(1) - points.at(0);
      EXPECT_NEAR(length(shaft), 0.15 * std::hypot(8, 8, 2), 1e-9);
      EXPECT_NEAR(dot(unit(shaft), unit(direction)), 1, 1e-12);
      // What has a place lies in [-4, 4] x [-4, 4] x [0, 2].
      for (const Point3& p : points) {
        EXPECT_TRUE(std::abs(p.x) > 4 || std::abs(p.y) > 4 || std::abs(p.z - 1) > 1) << p.x << ' ' << p.y << ' ' << p.z;
      }
    }
  }
}

TEST(PictureItems, DrawASunAsAnArrowOfLengthOneAlongItsDirection) {
  const PictureScene scene = picture_scene(source_of(scene_under(DirectionalLight{{3, 0, -4}})));
  for (const PictureItem& item : picture_items(scene)) {
    if (item.name != "light") continue;
    EXPECT_TRUE(item.in_corner);
    double low = 1;
    double high = -1;
    for (const Point3& p : points_of(*item.data)) {
      low = std::min(low, 0.6 * p.x - 0.8 * p.z);
      high = std::max(high, 0.6 * p.x - 0.8 * p.z);
    }
    EXPECT_NEAR(low, -0.5, 1e-6);
    EXPECT_NEAR(high, 0.5, 1e-6);
  }
}

}  // namespace
}  // namespace gnomon::viz
