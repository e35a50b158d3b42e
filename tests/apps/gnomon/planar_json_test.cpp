#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;

class PlanarJson : public Program {
 protected:
  json document(const std::string& scene, const std::string& options = {}) const {
    const Outcome run = gnomon("shadow " + scene + " --json - " + options);
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  }

  /// The only pair of an example.
  json pair_of(const std::string& figure, const std::string& options = {}) const {
    return document("examples/figure_" + figure + ".scene.json", options)["pairs"].at(0);
  }
};

json line(const std::string& contact, int blocker_end, int light_end) {
  return {{"contact", contact}, {"blocker_end", blocker_end}, {"light_end", light_end}};
}

TEST_F(PlanarJson, NamesTheFourExtremalLinesOfAPairInStandardPosition) {
  // The tube runs from left to right above the wall, which does so too.
  const json pair = pair_of("4_17");
  EXPECT_EQ(pair["position"], "standard");
  EXPECT_EQ(pair["lines"], json::array({line("separating", 0, 1), line("separating", 1, 0), line("supporting", 0, 0),
                                        line("supporting", 1, 1)}));
  EXPECT_FALSE(pair.contains("planes"));
}

TEST_F(PlanarJson, HasAnUnboundedUmbraBetweenTwoPenumbraeUnderASmallLight) {
  for (const std::string figure : {"4_17", "4_20_two_penumbrae"}) {
    const json pair = pair_of(figure);
    EXPECT_EQ(pair["lines"].size(), 4U) << figure;
    EXPECT_EQ(pair["umbra"]["bounded"], false) << figure;
    EXPECT_EQ(pair["umbra"]["components"], 1) << figure;
    EXPECT_EQ(pair["penumbra"]["components"], 2) << figure;
    EXPECT_EQ(pair["occlusion"]["components"], 1) << figure;
  }
}

TEST_F(PlanarJson, HasABoundedUmbraInOnePenumbraUnderALargeLight) {
  for (const std::string figure : {"4_18_one_umbra", "4_20_one_penumbra"}) {
    const json pair = pair_of(figure);
    EXPECT_EQ(pair["lines"].size(), 4U) << figure;
    EXPECT_EQ(pair["umbra"]["bounded"], true) << figure;
    EXPECT_EQ(pair["umbra"]["components"], 1) << figure;
    EXPECT_EQ(pair["penumbra"]["bounded"], false) << figure;
    EXPECT_EQ(pair["penumbra"]["components"], 1) << figure;
  }
}

TEST_F(PlanarJson, HasNoUmbraWhereTheLightCrossesTheBlockersLine) {
  const json pair = pair_of("4_18_no_umbra");
  EXPECT_EQ(pair["position"], "light_crosses_blocker_plane");
  EXPECT_EQ(pair["lines"].size(), 2U);
  EXPECT_EQ(pair["umbra"]["empty"], true);
  EXPECT_EQ(pair["umbra"]["components"], 0);
  EXPECT_EQ(pair["penumbra"]["components"], 2);
}

TEST_F(PlanarJson, HasNoPenumbraOfAPointLight) {
  const json pair = pair_of("4_20_no_penumbra");
  EXPECT_EQ(pair["lines"].size(), 4U);
  EXPECT_EQ(pair["penumbra"]["empty"], true);
  EXPECT_EQ(pair["umbra"], pair["occlusion"]);
}

TEST_F(PlanarJson, GivesAreasInTheBox) {
  // The wall [-1, 1] at height 2 under the tube [-3, 3] at height 5: the umbra is the triangle with its tip at
  // (0, 1/2). The occlusion ends in the lines that fall from the wall's ends by 3 on 4; at y = -1 its half width is 5.
  const json wide = pair_of("4_20_one_penumbra", "--box -10,-1,10,6");
  EXPECT_EQ(wide["umbra"]["volume_in_box"], 1.5);
  EXPECT_EQ(wide["occlusion"]["volume_in_box"], 18);
  EXPECT_EQ(wide["penumbra"]["volume_in_box"], 16.5);
  const json narrow = pair_of("4_20_one_penumbra", "--box 0,1,1,2");
  EXPECT_EQ(narrow["occlusion"]["volume_in_box"], 1);
}

TEST_F(PlanarJson, StatesTheBoxAsTheOptionTakesIt) {
  EXPECT_EQ(document("examples/figure_4_17.scene.json", "--box -10,-5,10,6")["clip_box"],
            json::array({-10, -5, 10, 6}));
}

TEST_F(PlanarJson, TakesAPolylineSegmentBySegment) {
  write("fence.scene.json", R"({"gnomon": 1, "dimension": 2,
    "lights": [{"name": "bulb", "shape": "point", "position": [0, 4]}],
    "blockers": [
      {"name": "fence", "shape": "polyline", "vertices": [[-1, 2], [0, 2], [1, 1]]},
      {"name": "stick", "shape": "segment", "vertices": [[3, 2], [4, 2]]}]})");
  const json pairs = document("fence.scene.json", "--box -4,0,8,4")["pairs"];
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_EQ(pairs[0]["blocker"], "fence#0");
  EXPECT_EQ(pairs[1]["blocker"], "fence#1");
  EXPECT_EQ(pairs[2]["blocker"], "stick");
  // From width 1 at y = 2 to width 2 at y = 0.
  EXPECT_EQ(pairs[0]["umbra"]["volume_in_box"], 3);
  EXPECT_EQ(document("fence.scene.json", "--blocker fence")["pairs"].size(), 2U);
}

TEST_F(PlanarJson, TellsOfALightBehindAllSegmentsTogether) {
  const json document = this->document("examples/figure_4_21.scene.json");
  ASSERT_EQ(document["lights"].size(), 1U);
  const json& light = document["lights"][0];
  EXPECT_EQ(light["light"], "tube");
  EXPECT_EQ(light["blockers"], json::array({"left", "right"}));
  EXPECT_EQ(light["umbra"]["components"], 2);
  EXPECT_EQ(light["penumbra"]["components"], 2);
  double alone = 0;
  for (const json& pair : document["pairs"]) alone += pair["umbra"]["volume_in_box"].get<double>();
  EXPECT_GT(light["umbra"]["area_in_box"], alone);
}

TEST_F(PlanarJson, SaysNoMoreThanThePairWhereThereIsOnlyOne) {
  EXPECT_FALSE(document("examples/figure_4_17.scene.json").contains("lights"));
}

}  // namespace
}  // namespace gnomon
