#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "gnomon/flatland_regions.h"
#include "gnomon/scene.h"

namespace gnomon::planar {
namespace {

ShadowRegions regions_of_example(const std::string& name) {
  const auto scene = std::get<PlaneScene>(read_scene(std::filesystem::path(GNOMON_EXAMPLES) / (name + ".scene.json")));
  return shadow_regions(Pair::from_points(scene.lights.at(0).vertices, scene.blockers.at(0).vertices));
}

TEST(ThesisFigures, Figure417HasFourExtremalLines) {
  const ShadowRegions regions = regions_of_example("figure_4_17");
  EXPECT_EQ(pair_position(regions.pair), Position::standard);
  EXPECT_EQ(regions.lines.size(), 4u);
  EXPECT_EQ(regions.umbra.components, 1u);
}

TEST(ThesisFigures, Figure418HasOneUmbraOrNone) {
  EXPECT_EQ(regions_of_example("figure_4_18_one_umbra").umbra.components, 1u);
  const ShadowRegions none = regions_of_example("figure_4_18_no_umbra");
  EXPECT_EQ(none.umbra.components, 0u);
  EXPECT_EQ(pair_position(none.pair), Position::light_crosses_blocker_plane);
}

// Figure 4.19: the supporting lines meet behind the blocker, are parallel, or meet before it.
TEST(ThesisFigures, Figure419HasOneUmbraHoweverTheSupportingLinesRun) {
  for (const double half_width : {2.0, 1.0, 0.5}) {
    const Point2 light[] = {{-half_width, 2}, {half_width, 2}};
    const Point2 blocker[] = {{-1, 0}, {1, 0}};
    const ShadowRegions regions = shadow_regions(Pair::from_points(light, blocker));
    EXPECT_EQ(regions.umbra.components, 1u);
    EXPECT_EQ(regions.umbra.bounded(), half_width > 1);
  }
}

TEST(ThesisFigures, Figure420HasOneTwoOrNoPenumbrae) {
  EXPECT_EQ(regions_of_example("figure_4_20_one_penumbra").penumbra.components, 1u);
  EXPECT_EQ(regions_of_example("figure_4_20_two_penumbrae").penumbra.components, 2u);
  EXPECT_EQ(regions_of_example("figure_4_20_no_penumbra").penumbra.components, 0u);
}

}  // namespace
}  // namespace gnomon::planar
