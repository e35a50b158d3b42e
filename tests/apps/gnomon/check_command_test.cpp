#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <sstream>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class CheckCommand : public Program {
 protected:
  CheckCommand() { write("mixed.scene.json", mixed_scene); }
};

TEST_F(CheckCommand, PrintsWhatWasRecognised) {
  const Outcome run = gnomon("check mixed.scene.json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  EXPECT_THAT(run.out, AllOf(HasSubstr("2 lights, 3 blockers, 0 receivers"), HasSubstr("lamp"), HasSubstr("polytope"),
                             HasSubstr("4 vertices"), HasSubstr("one-sided"), HasSubstr("radiance 1 W/(m^2 sr)")));
}

TEST_F(CheckCommand, TellsTheFluxOfEveryLightThatHasOne) {
  write("tube.scene.json", R"({"gnomon": 1, "dimension": 3, "length_unit": "cm", "blockers": [], "lights": [
    {"name": "tube", "shape": "segment", "vertices": [[0,0,0], [100,0,0]], "intensity_per_length": 2,
     "emission": {"profile": "cosine"}},
    {"name": "sun", "shape": "direction", "direction": [0,0,-1]}]})");
  const Outcome run = gnomon("check tube.scene.json --json tube.json");
  EXPECT_THAT(run.out, HasSubstr("flux 19.7392 W"));
  const json lights = read_json("tube.json")["lights"];
  EXPECT_NEAR(lights[0]["flux"].get<double>(), 2 * 9.8696044010893586, 2e-11);
  EXPECT_FALSE(lights[1].contains("flux"));
}

TEST_F(CheckCommand, DoubtsLightsInSolidsAndClosedMeshes) {
  write("room.obj",
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 3\nv 4 0 3\nv 4 4 2\nv 0 4 3\nv 2 2 1\n"
        "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 9\nf 6 7 9\nf 7 8 9\nf 8 5 9\n");
  write("inside.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [
    {"name": "bulb", "shape": "point", "position": [0.5, 0.5, 1]}, {"name": "moon", "shape": "point", "position": [0, 0, 9]},
    {"name": "buried", "shape": "point", "position": [11, 1, 1]}], "blockers": [
    {"name": "room", "shape": "mesh", "file": "room.obj"}, {"name": "block", "shape": "polytope",
     "vertices": [[10,0,0], [12,0,0], [12,2,0], [10,2,0], [10,0,2], [12,0,2], [12,2,2], [10,2,2]]}]})");
  const Outcome run = gnomon("check inside.scene.json --json inside.json");
  EXPECT_THAT(
      read_json("inside.json").at("doubts"),
      testing::ElementsAre(testing::StartsWith("light \"bulb\": it reaches into blocker \"room\", a closed mesh"),
                           testing::StartsWith("light \"buried\": it reaches into blocker \"block\", a solid")));
}

TEST_F(CheckCommand, DoubtsLightsOnSolidsThatShineIntoThem) {
  write("on.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [
    {"name": "into", "shape": "polygon", "vertices": [[0,0,2], [0,1,2], [1,1,2], [1,0,2]]},
    {"name": "away", "shape": "polygon", "vertices": [[0,0,2], [1,0,2], [1,1,2], [0,1,2]]},
    {"name": "both", "shape": "polygon", "two_sided": true, "vertices": [[0,0,2], [0,1,2], [1,1,2], [1,0,2]]},
    {"name": "wider", "shape": "polygon", "vertices": [[0,0,2], [0,3,2], [3,3,2], [3,0,2]]}], "blockers": [
    {"name": "board", "shape": "polygon", "vertices": [[0,0,5], [1,0,5], [1,1,5], [0,1,5]]}, {"name": "block", "shape":
     "polytope", "vertices": [[0,0,0], [2,0,0], [2,2,0], [0,2,0], [0,0,2], [2,0,2], [2,2,2], [0,2,2]]}]})");
  ASSERT_EQ(gnomon("check on.scene.json --json on.json").code, 0);
  EXPECT_THAT(
      read_json("on.json").at("doubts"),
      testing::ElementsAre(testing::StartsWith("light \"into\": it lies on blocker \"block\" and shines into")));
}

TEST_F(CheckCommand, DoubtsLampsThatWereRoundedOffTheWallTheyLieOn) {
  // A wall that is turned, and a panel in it; beside it another, and one in a level ceiling.
  const auto ring = [](double low, double high, double bottom, double top) {
    std::ostringstream text;
    text << std::setprecision(17);
    const double c = std::cos(0.5), s = std::sin(0.5);
    for (const auto& [u, z] : {std::pair{low, bottom}, {high, bottom}, {high, top}, {low, top}}) {
      text << (text.tellp() > 0 ? ",[" : "[") << c * u - s << ',' << s * u + c << ',' << z << ']';
    }
    return text.str();
  };
  write("wall.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [
    {"name": "panel", "shape": "polygon", "vertices": [)" +
                               ring(1.1, 1.7, 0.3, 0.9) + R"(]},
    {"name": "beside", "shape": "polygon", "vertices": [)" +
                               ring(5.1, 5.7, 0.3, 0.9) + R"(]},
    {"name": "above", "shape": "polygon", "vertices": [[0,0,9], [0,1,9], [1,1,9], [1,0,9]]}], "blockers": [
    {"name": "ceiling", "shape": "polygon", "vertices": [[-9,-9,9], [9,-9,9], [9,9,9], [-9,9,9]]},
    {"name": "wall", "shape": "polygon", "vertices": [)" +
                               ring(0, 3, 0, 2) + "]}]}");
  ASSERT_EQ(gnomon("check wall.scene.json --json wall.json").code, 0);
  std::vector<std::string> doubts;
  const json all = read_json("wall.json").at("doubts");
  for (const json& doubt : all) {
    if (doubt.get<std::string>().find("rounded off") != std::string::npos) doubts.push_back(doubt);
  }
  EXPECT_THAT(doubts, testing::ElementsAre(testing::StartsWith("light \"panel\": it lies on blocker \"wall\"")));
}

TEST_F(CheckCommand, DoubtsReceiversThatAreBlockersOfAnotherMaterial) {
  const auto doubts_of = [&](const std::string& blocker, const std::string& receiver) {
    write("two.scene.json", R"({"gnomon": 1, "dimension": 3, "materials": [{"name": "red"}, {"name": "blue"}],
      "lights": [{"name": "bulb",
      "shape": "point", "position": [0, 0, 5]}], "blockers": [{"name": "table", "shape": "polygon", )" +
                                blocker + R"( "vertices": [[0,0,0], [1,0,0], [1,1,0], [0,1,0]]}], "receivers": [
      {"name": "top", "shape": "polygon", )" +
                                receiver + R"( "vertices": [[1,0,0], [1,1,0], [0,1,0], [0,0,0]]}]})");
    EXPECT_EQ(gnomon("check two.scene.json --json two.json").code, 0);
    return read_json("two.json").at("doubts");
  };
  EXPECT_THAT(
      doubts_of(R"("material": "red",)", R"("material": "blue",)"),
      testing::ElementsAre(testing::StartsWith("receiver \"top\": its vertices are those of blocker \"table\"")));
  EXPECT_THAT(doubts_of(R"("material": "red",)", R"("material": "red",)"), IsEmpty());
  EXPECT_THAT(doubts_of(R"("material": "red",)", ""), IsEmpty());
}

TEST_F(CheckCommand, NeverShortensAStrength) {
  write("named.scene.json", R"({"gnomon": 1, "dimension": 3, "blockers": [], "lights": [
    {"name": "lamp of the hall with a long name", "shape": "polygon", "radiance": 2.5,
     "vertices": [[0,0,0], [1,0,0], [1,1,0], [0,1,0]]}]})");
  std::string all = gnomon("check named.scene.json").out;
  for (const std::string& line : lines(all)) EXPECT_LE(line.size(), 80U) << line;
  std::erase(all, '\n');
  const auto is_doubled_blank = [](char a, char b) { return a == ' ' && b == ' '; };
  all.erase(std::unique(all.begin(), all.end(), is_doubled_blank), all.end());
  EXPECT_THAT(all, HasSubstr("radiance 2.5 W/(m^2 sr), flux 7.85398 W"));
}

TEST_F(CheckCommand, PrintsEveryPairWithItsPositionOrTheReason) {
  EXPECT_THAT(gnomon("check mixed.scene.json").out,
              AllOf(HasSubstr("6 of 6 supported"), HasSubstr("standard"), HasSubstr("light_crosses_blocker_plane"),
                    HasSubstr("coplanar")));
  write("bent_lamp.scene.json", bent_lamp_scene);
  EXPECT_THAT(gnomon("check bent_lamp.scene.json").out,
              AllOf(HasSubstr("1 of 2 supported"), HasSubstr("strictly apart")));
}

TEST_F(CheckCommand, PrintsAtMost20PairsUnsupportedOnesFirst) {
  std::string blockers = R"({"name": "shelf", "shape": "polygon", "vertices": [[2,-1,3], [2,1,3], [2,1,5], [2,-1,5]]})";
  for (int i = 0; i < 60; ++i) {
    const std::string x = std::to_string(10 * i), right = std::to_string(10 * i + 1);
    blockers = R"({"name": "leaf)" + std::to_string(i) + R"(", "shape": "polygon", "vertices": [[)" + x + ",0,1],[" +
               right + ",0,1],[" + x + ",1,1]]}," + blockers;
  }
  write("many.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [{"name": "lamp", "shape": "polygon",
    "vertices": [[-1,-1,4], [-1,1,4], [1,1,4], [1,-1,4.000000000001]]}], "blockers": [)" +
                               blockers + "]}");
  const Outcome run = gnomon("check many.scene.json --json all.json");
  const std::string pairs = run.out.substr(run.out.find("pairs, "));
  EXPECT_THAT(pairs, AllOf(HasSubstr("60 of 61 supported"), HasSubstr("shelf"), HasSubstr("and 41 more")));
  std::size_t lines = 0;
  for (std::size_t at = pairs.find("\n  lamp  "); at != std::string::npos; at = pairs.find("\n  lamp  ", at + 1))
    ++lines;
  EXPECT_EQ(lines, 20u);
  EXPECT_EQ(read_json("all.json")["pairs"].size(), 61u);
}

TEST_F(CheckCommand, PrintsEveryDoubt) {
  // The last vertex is off the plane by far less than 1e-9 of the diameter.
  write("rounded.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "bulb", "shape": "point", "position": [0,0,5]}],
    "blockers": [{"name": "leaf", "shape": "polygon", "vertices": [[-1,-1,0], [1,-1,0], [1,1,0], [-1,1,1e-12]]}]})");
  const Outcome run = gnomon("check rounded.scene.json --json result.json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("doubts\n"), HasSubstr("leaf"), HasSubstr("1 of 1 supported")));
  const json result = read_json("result.json");
  EXPECT_EQ(result["doubts"].size(), 1U);
  EXPECT_EQ(result["pairs"][0]["position"], "standard");
  EXPECT_FALSE(result["pairs"][0].contains("reason"));
}

TEST_F(CheckCommand, PrintsTheJsonAloneOnStandardOutput) {
  const Outcome run = gnomon("check mixed.scene.json --json -");
  EXPECT_EQ(run.code, 0);
  const json result = json::parse(run.out);
  EXPECT_EQ(result["schema"], "gnomon/check/1");
  EXPECT_EQ(result["dimension"], 3);
  EXPECT_EQ(result["lights"][0], (json{{"name", "lamp"},
                                       {"shape", "polygon"},
                                       {"vertices", 4},
                                       {"two_sided", false},
                                       {"radiance", 1.0},
                                       {"unit", "W/(m^2 sr)"},
                                       {"flux", 12.566370614359172}}));
  EXPECT_EQ(result["blockers"][2], (json{{"name", "post"}, {"shape", "polytope"}, {"vertices", 4}}));
  EXPECT_EQ(result["receivers"], json::array());
  EXPECT_EQ(result["doubts"], json::array());
  EXPECT_EQ(result["pairs"].size(), 6U);
  EXPECT_EQ(result["clip_box"].size(), 6U);
}

TEST_F(CheckCommand, CountsTheFacetsOfAMesh) {
  write("vase.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  write("vase.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "bulb", "shape": "point", "position": [0,0,5]}],
    "blockers": [{"name": "vase", "shape": "mesh", "file": "vase.obj"}]})");
  const Outcome run = gnomon("check vase.scene.json --json -");
  EXPECT_EQ(run.code, 0) << run.err;
  const json vase = json::parse(run.out)["blockers"][0];
  EXPECT_EQ(vase["vertices"], 4);
  EXPECT_EQ(vase["facets"], 4);
  EXPECT_EQ(vase["closed"], true);
}

TEST_F(CheckCommand, RecognisesPlanarScenes) {
  write("plane.scene.json", R"({"gnomon": 1, "dimension": 2,
    "lights": [{"name": "tube", "shape": "segment", "vertices": [[-1, 2], [1, 2]]}],
    "blockers": [{"name": "fence", "shape": "polyline", "vertices": [[-1, 1], [0, 1], [1, 0]]}]})");
  const Outcome run = gnomon("check plane.scene.json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("dimension 2"), HasSubstr("tube"), HasSubstr("polyline"), HasSubstr("3 vertices")));
  EXPECT_THAT(run.out, AllOf(HasSubstr("2 of 2 supported"), HasSubstr("fence#0"), HasSubstr("fence#1")));
}

TEST_F(CheckCommand, PrintsNothingForAGoodSceneWhenQuiet) {
  const Outcome run = gnomon("check mixed.scene.json --quiet");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out + run.err, IsEmpty());
}

TEST_F(CheckCommand, EndsWith3NamingFileElementAndExpectation) {
  write("straight.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "bulb", "shape": "point", "position": [0,0,5]}],
    "blockers": [{"name": "leaf", "shape": "polygon", "vertices": [[0,0,0], [1,0,0], [2,0,0]]}]})");
  const Outcome run = gnomon("check straight.scene.json");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err, AllOf(HasSubstr("straight.scene.json"), HasSubstr("/blockers/0"), HasSubstr("leaf")));
}

TEST_F(CheckCommand, TellsASceneThatHoldsAMeshFile) {
  write("vase.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const Outcome run = gnomon("check vase.obj");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, AllOf(HasSubstr("vase.obj: found a mesh, expected a scene"), HasSubstr("\"floor\"")));
  write("told.scene.json", run.err.substr(run.err.find('{')));
  EXPECT_EQ(gnomon("receivers told.scene.json --json -").code, 0);
  write("broken.obj", "v 0 0 nan\n");
  EXPECT_THAT(gnomon("check broken.obj").err, AllOf(HasSubstr("broken.obj"), HasSubstr("line 1")));
}

TEST_F(CheckCommand, GivesWarningsOfItsDoubtsToEveryOtherCommand) {
  write("dark.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "bulb", "shape": "point", "position": [0,0,5], "intensity": 0}],
    "blockers": [{"name": "leaf", "shape": "polygon", "vertices": [[-1,-1,0], [1,-1,0], [1,1,0], [-1,1,0]]}],
    "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[-1,-1,-1], [1,-1,-1], [1,1,-1], [-1,1,-1]]}]})");
  write("points.csv", "x,y,z\n0,0,-1\n");
  write("normals.csv", "x,y,z,nx,ny,nz\n0,0,-1,0,0,1\n");
  const std::string warning = "gnomon: warning: dark.scene.json: light \"bulb\": its strength is 0";
  for (const std::string command :
       {"regions dark.scene.json --at points.csv", "irradiance dark.scene.json --at normals.csv --quiet",
        "shadow dark.scene.json --json -", "receivers dark.scene.json --json -",
        "discontinuities dark.scene.json --json -",
        "grid dark.scene.json --shape 2,2,2 --box=-1,-1,-1,1,1,1 --out grid.vti",
        "render dark.scene.json --out dark.gltf", "check dark.scene.json --quiet"}) {
    const Outcome run = gnomon(command);
    EXPECT_EQ(run.code, 0) << command << run.err;
    EXPECT_THAT(run.err, HasSubstr(warning)) << command;
  }
  EXPECT_THAT(gnomon("check dark.scene.json").err, IsEmpty());
}

TEST_F(CheckCommand, TellsOfManyDoubtsTheFirstAsWarningsAndHowManyMoreThereAre) {
  std::string lights;
  for (int i = 0; i < 15; ++i) {
    lights += (i ? ", " : "") + std::string(R"({"name": "l)") + std::to_string(i) +
              R"(", "shape": "point", "position": [0,0,5], "intensity": 0})";
  }
  write("dark.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [)" + lights + R"(], "blockers": []})");
  write("points.csv", "x,y,z\n0,0,-1\n");
  EXPECT_THAT(gnomon("regions dark.scene.json --at points.csv").err,
              AllOf(HasSubstr("\"l8\""), Not(HasSubstr("\"l10\"")), HasSubstr("6 further doubts")));
}

}  // namespace
}  // namespace gnomon
