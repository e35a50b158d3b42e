#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;

class ShadowJson : public Program {
 protected:
  /// The document for a scene and a box.
  json document(const std::string& scene, const std::string& options = "--box -10,-10,0,10,10,4") const {
    write("scene.json", scene);
    return json::parse(gnomon("shadow scene.json --json - " + options).out);
  }
};

std::size_t count_planes(const json& planes, const std::string& contact, const std::string& edge_of) {
  return static_cast<std::size_t>(std::count_if(planes.begin(), planes.end(), [&](const json& plane) {
    return plane["contact"] == contact && plane["edge"]["of"] == edge_of;
  }));
}

TEST_F(ShadowJson, StatesSchemaSceneBoxAndUnit) {
  const json result = document(table_scene);
  EXPECT_EQ(result["schema"], "gnomon/shadow/1");
  EXPECT_EQ(result["scene"], "scene.json");
  EXPECT_EQ(result["length_unit"], "m");
  EXPECT_EQ(result["clip_box"], json::array({-10, -10, 0, 10, 10, 4}));
}

TEST_F(ShadowJson, NamesEveryPlaneOfAlignedSquaresByABlockerEdge) {
  const json pair = document(table_scene)["pairs"].at(0);
  EXPECT_EQ(pair["light"], "lamp");
  EXPECT_EQ(pair["blocker"], "table");
  EXPECT_EQ(pair["position"], "standard");
  EXPECT_EQ(pair["supported"], true);
  EXPECT_EQ(count_planes(pair["planes"], "separating", "blocker"), 4U);
  EXPECT_EQ(count_planes(pair["planes"], "separating", "light"), 0U);
  EXPECT_EQ(count_planes(pair["planes"], "supporting", "blocker"), 4U);
}

TEST_F(ShadowJson, NamesTheLowestOfTheVerticesThatTouch) {
  // Edge 0 of the table runs along y = -2. The separating plane through it touches the lamp's edge y = 1, vertices 1
  // and 2; the supporting one its edge y = -1, vertices 0 and 3.
  const json separating = {{"contact", "separating"},
                           {"edge", {{"of", "blocker"}, {"index", 0}}},
                           {"vertex", {{"of", "light"}, {"index", 1}}}};
  const json supporting = {{"contact", "supporting"},
                           {"edge", {{"of", "blocker"}, {"index", 0}}},
                           {"vertex", {{"of", "light"}, {"index", 0}}}};
  json planes = document(table_scene)["pairs"].at(0)["planes"];
  for (json& plane : planes) {
    for (const char* number : {"coefficients", "exact"}) EXPECT_EQ(plane.erase(number), 1u);
  }
  EXPECT_EQ(std::count(planes.begin(), planes.end(), separating), 1);
  EXPECT_EQ(std::count(planes.begin(), planes.end(), supporting), 1);
}

/// a x + b y + c z + d of a plane's coefficients.
double value_at(const json& plane, double x, double y, double z) {
  const json& c = plane["coefficients"];
  return c.at(0).get<double>() * x + c.at(1).get<double>() * y + c.at(2).get<double>() * z + c.at(3).get<double>();
}

TEST_F(ShadowJson, GivesThePlanesCoefficientsWithTheVolumeOnTheNegativeSide) {
  // The table's edge 0 is y = -2 at height 2; the lamp's edges y = 1 and y = -1 are at height 4.
  for (const json& plane : document(table_scene)["pairs"].at(0)["planes"]) {
    if (plane["edge"]["index"] != 0) continue;
    const bool separates = plane["contact"] == "separating";
    EXPECT_EQ(value_at(plane, 7, -2, 2), 0) << plane;
    EXPECT_EQ(value_at(plane, -7, separates ? 1 : -1, 4), 0) << plane;
    EXPECT_LT(value_at(plane, 0, 0, 0), 0) << plane;
    EXPECT_EQ(plane["exact"].size(), 4u);
    EXPECT_EQ(plane["exact"].at(0), "0");
  }
}

TEST_F(ShadowJson, GivesVolumesInTheBoxCorrectlyRounded) {
  // Integrals of (4 + 3t)^2 and (4 + t)^2 for the depth t from 0 to 2.
  const json pair = document(table_scene)["pairs"].at(0);
  EXPECT_EQ(pair["occlusion"]["volume_in_box"], 104.0);
  EXPECT_EQ(pair["umbra"]["volume_in_box"], 152.0 / 3);
  EXPECT_EQ(pair["penumbra"]["volume_in_box"], 160.0 / 3);
}

TEST_F(ShadowJson, SaysWhetherVolumesAreEmptyBoundedAndConnected) {
  const json pair = document(table_scene)["pairs"].at(0);
  for (const char* volume : {"occlusion", "umbra", "penumbra"}) {
    EXPECT_EQ(pair[volume]["empty"], false) << volume;
    EXPECT_EQ(pair[volume]["bounded"], false) << volume;
    EXPECT_EQ(pair[volume]["components"], 1) << volume;
  }
}

TEST_F(ShadowJson, ShowsABoundedUmbraUnderALargeLamp) {
  const json pair = document(R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[-2,-2,4], [-2,2,4], [2,2,4], [2,-2,4]]}],
    "blockers": [{"name": "plate", "shape": "polygon", "vertices": [[-1,-1,3], [1,-1,3], [1,1,3], [-1,1,3]]}]})")
                        ["pairs"]
                            .at(0);
  EXPECT_EQ(pair["umbra"]["bounded"], true);
  EXPECT_EQ(pair["occlusion"]["bounded"], false);
  EXPECT_EQ(pair["umbra"]["volume_in_box"], 4.0 / 3);  // a pyramid of base 2 x 2 and height 1
}

TEST_F(ShadowJson, GivesUnsupportedPairsAPositionAndAReason) {
  const json pairs = document(bent_lamp_scene)["pairs"];
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0]["supported"], true);
  EXPECT_TRUE(pairs[1]["position"].is_string());
  EXPECT_EQ(pairs[1]["supported"], false);
  EXPECT_FALSE(pairs[1]["reason"].get<std::string>().empty());
  for (const char* absent : {"planes", "occlusion", "umbra", "penumbra"}) EXPECT_FALSE(pairs[1].contains(absent));
}

TEST_F(ShadowJson, NamesPositionsAndEmptyShadows) {
  const json pairs = document(mixed_scene)["pairs"];
  ASSERT_EQ(pairs.size(), 6U);
  EXPECT_EQ(pairs[1]["position"], "light_crosses_blocker_plane");
  EXPECT_EQ(pairs[1]["umbra"]["empty"], true);
  EXPECT_EQ(pairs[1]["penumbra"]["components"], 2);
  EXPECT_EQ(pairs[4]["position"], "coplanar");  // the sun's rays run along the wall
  EXPECT_EQ(pairs[4]["occlusion"]["empty"], true);
}

TEST_F(ShadowJson, NamesTheEdgesOfASolidByTheirVerticesAndCountsPockets) {
  const json pair = document(mixed_scene)["pairs"].at(2);
  ASSERT_FALSE(pair["planes"].empty());
  for (const json& plane : pair["planes"]) {
    EXPECT_EQ(plane["edge"].contains("vertices"), plane["edge"]["of"] == "blocker");
  }
  EXPECT_EQ(pair["umbra"]["pockets"], 1);
}

TEST_F(ShadowJson, TellsWhichVerticesAPartOfABlockerHas) {
  const json pairs = document(R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "bulb", "shape": "point", "position": [0,0,9]}],
    "blockers": [{"name": "arrow", "shape": "concave_polygon", "vertices": [[0,0,0], [4,0,0], [1,1,0], [0,4,0]]}]})")
      ["pairs"];
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0]["blocker"], "arrow#0");
  EXPECT_EQ(pairs[0]["blocker_vertices"].size(), 3U);
}

TEST_F(ShadowJson, ListsPairsLightByLightInFileOrder) {
  std::vector<std::string> names;
  const json result = document(mixed_scene);
  for (const json& pair : result["pairs"]) {
    names.push_back(pair["light"].get<std::string>() + "/" + pair["blocker"].get<std::string>());
  }
  EXPECT_THAT(names, testing::ElementsAre("lamp/table", "lamp/wall", "lamp/post", "sun/table", "sun/wall", "sun/post"));
}

TEST_F(ShadowJson, PrintsNumbersThatReadBackAsTheSameDoubles) {
  const json box = document(table_scene, "--box -0.1,-1e-300,0.30000000000000004,1e22,3,4")["clip_box"];
  EXPECT_EQ(box, json::array({-0.1, -1e-300, 0.30000000000000004, 1e22, 3.0, 4.0}));
}

TEST_F(ShadowJson, DoesNotDependOnTheNumberOfThreads) {
  const std::string command = "shadow examples/cornell_box.scene.json --json - --threads ";
  const Outcome one = gnomon(command + "1");
  ASSERT_EQ(one.code, 0);
  EXPECT_EQ(gnomon(command + "2").out, one.out);
  EXPECT_EQ(gnomon(command + "64").out, one.out);
}

TEST_F(ShadowJson, ComputesEveryPairOfTheCornellBoxWhereverItStands) {
  const json result = json::parse(gnomon("shadow examples/cornell_box.scene.json --json -").out);
  EXPECT_EQ(result["length_unit"], "mm");
  ASSERT_EQ(result["pairs"].size(), 10U);
  for (const json& pair : result["pairs"]) {
    EXPECT_EQ(pair["supported"], true) << pair["blocker"];
    EXPECT_EQ(pair["umbra"]["empty"], pair["position"] != "standard") << pair["blocker"];
  }
}

TEST_F(ShadowJson, DescribesTheDefaultScene) {
  const json result = json::parse(gnomon("shadow --json -").out);
  EXPECT_EQ(result["scene"], "default");
  ASSERT_EQ(result["pairs"].size(), 1U);
  const json pair = result["pairs"][0];
  EXPECT_EQ(pair["position"], "standard");
  EXPECT_EQ(count_planes(pair["planes"], "supporting", "blocker"), 4U);  // a rectangle
  EXPECT_EQ(count_planes(pair["planes"], "separating", "blocker"), 4U);
  EXPECT_EQ(count_planes(pair["planes"], "separating", "light"), 3U);  // below a triangle
}

}  // namespace
}  // namespace gnomon
