#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

/// A bulb 2 above the origin, and what surfaces may be made of.
std::string scene_with(const std::string& materials, const std::string& light_keys = "") {
  return R"({"gnomon": 1, "dimension": 3, "blockers": [], "ambient_radiance": 2, )" + materials + R"(
    "lights": [{"name": "bulb", "shape": "point", "position": [0, 0, 2], "intensity": 4)" +
         light_keys + "}]}";
}

class RadianceCommand : public Program {
 protected:
  RadianceCommand() { write("views.csv", "x,y,z,nx,ny,nz,ex,ey,ez\n0,0,0,0,0,1,0,0,5\n0,0,0,0,0,1,0,0,-5\n"); }
};

TEST_F(RadianceCommand, TellsLightsAmbientAndTotalViewByView) {
  write(
      "grey.scene.json",
      scene_with(R"("materials": [{"name": "m", "diffuse": 0.5, "specular": 0.25, "ambient": 0.5, "exponent": 2}],)"));
  const Outcome run = gnomon("radiance grey.scene.json --at views.csv --json r.json --quiet");
  EXPECT_EQ(run.code, 0) << run.err;
  ASSERT_THAT(lines(run.out), SizeIs(7));
  EXPECT_EQ(lines(run.out)[0], "x,y,z,nx,ny,nz,ex,ey,ez,light,radiance,error_bound");
  EXPECT_THAT(lines(run.out)[1], StartsWith("0,0,0,0,0,1,0,0,5,bulb,0.3"));
  EXPECT_THAT(lines(run.out)[2], StartsWith("0,0,0,0,0,1,0,0,5,ambient,1,"));
  EXPECT_EQ(lines(run.out)[4], "0,0,0,0,0,1,0,0,-5,bulb,0,0") << "from behind";
  const json result = read_json("r.json");
  EXPECT_EQ(result["schema"], "gnomon/radiance/1");
  EXPECT_EQ(result["material"], "m");
  const json& bulb = result["points"][0]["lights"][0];
  const double exact = 0.5 / std::numbers::pi + 0.25 * 4 / (2 * std::numbers::pi);
  EXPECT_LE(std::fabs(bulb["radiance"][1].get<double>() - exact), bulb["error_bound"][1].get<double>());
  EXPECT_NEAR(result["points"][0]["total"]["radiance"][2].get<double>(), exact + 1, 1e-14);
}

TEST_F(RadianceCommand, HasColumnsForEachColourWhereTheyDiffer) {
  write("red.scene.json",
        scene_with(R"("materials": [{"name": "m", "diffuse": [0.5, 0, 0]}],)", R"(, "color": [1, 1, 0])"));
  const Outcome run = gnomon("radiance red.scene.json --at views.csv --quiet");
  EXPECT_THAT(lines(run.out)[0],
              HasSubstr("light,radiance_r,error_bound_r,radiance_g,error_bound_g,radiance_b,error_bound_b"));
  EXPECT_THAT(lines(run.out)[1], testing::EndsWith(",0,0,0,0"));
}

TEST_F(RadianceCommand, WantsAMaterialByNameWhereThereAreSeveral) {
  write("two.scene.json", scene_with(R"("materials": [{"name": "a"}, {"name": "b", "model": "blinn"}],)"));
  EXPECT_EQ(gnomon("radiance two.scene.json --at views.csv").code, 2);
  const Outcome unknown = gnomon("radiance two.scene.json --at views.csv --material c");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, AllOf(HasSubstr("'c'"), HasSubstr("a, b")));
  EXPECT_EQ(gnomon("radiance two.scene.json --at views.csv --material b").code, 0);
}

TEST_F(RadianceCommand, RefusesMaterialsThatMakeNoSense) {
  const auto refusal = [this](const std::string& material) {
    write("bad.scene.json", scene_with(R"("materials": [{"name": "m", )" + material + "}],"));
    const Outcome run = gnomon("radiance bad.scene.json --at views.csv");
    EXPECT_EQ(run.code, 3) << material;
    EXPECT_THAT(run.err, HasSubstr("material \"m\"")) << material;
    return run.err;
  };
  for (const char* exponent : {"3.5", "-1", "10001"}) {
    EXPECT_THAT(refusal(R"("exponent": )" + std::string(exponent)),
                AllOf(HasSubstr("/materials/0/exponent"), HasSubstr("a whole number from 0 to 10000")));
  }
  EXPECT_THAT(refusal(R"("diffuse": 1.5)"), HasSubstr("a number from 0 to 1"));
  EXPECT_THAT(refusal(R"("specular": [0.1, 0.2])"), HasSubstr("[red, green, blue]"));
  EXPECT_THAT(refusal(R"("model": "ggx")"), AllOf(HasSubstr("\"ggx\""), HasSubstr("\"blinn_classic\"")));
  EXPECT_THAT(refusal(R"("shine": 3)"), HasSubstr("the unknown key \"shine\""));
}

TEST_F(RadianceCommand, RefusesAMaterialThatTheSceneDoesNotHave) {
  write("bad.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [], "blockers": [{"name": "t", "shape": "polygon",
    "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "material": "gold"}]})");
  const Outcome run = gnomon("radiance bad.scene.json --at views.csv");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, AllOf(HasSubstr("/blockers/0/material"), HasSubstr("gold"), HasSubstr("\"materials\"")));
}

TEST_F(RadianceCommand, DoubtsMaterialsThatReflectMoreThanArrives) {
  write("bright.scene.json", scene_with(R"("materials": [{"name": "m", "diffuse": 0.9, "specular": 0.3}],)"));
  const Outcome run = gnomon("radiance bright.scene.json --at views.csv");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("material \"m\": diffuse and specular together are 1.2"));
}

TEST_F(RadianceCommand, TellsLinesThatAreNoViews) {
  write("grey.scene.json", scene_with(""));
  write("some.csv", "x,y,z,nx,ny,nz,ex,ey,ez\n0,0,0,0,0,0,0,0,5\n0,0,0,0,0,1,0,0,0\n0,0,0,0,0,1,1,1,x\n");
  const Outcome run = gnomon("radiance grey.scene.json --at some.csv");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err,
              AllOf(HasSubstr("some.csv:2: nx,ny,nz"), HasSubstr("some.csv:3: ex,ey,ez"), HasSubstr("some.csv:4: ez")));
  write("short.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,1\n");
  EXPECT_THAT(gnomon("radiance grey.scene.json --at short.csv").err, HasSubstr("x,y,z,nx,ny,nz,ex,ey,ez"));
}

/// A floor of lacquer under a bulb.
const std::string seen_floor = R"({"gnomon": 1, "dimension": 3, "blockers": [],
  "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0]},
  "materials": [{"name": "chalk"}, {"name": "lacquer", "diffuse": 0, "specular": 1, "exponent": 0}],
  "lights": [{"name": "bulb", "shape": "point", "position": [0, 0, 2], "intensity": 4}],
  "receivers": [{"name": "floor", "shape": "polygon", "material": "lacquer",
                 "vertices": [[-1,-1,0], [1,-1,0], [1,1,0], [-1,1,0]]}]})";

TEST_F(RadianceCommand, IsSpreadOverAReceiverOfItsMaterial) {
  write("floor.scene.json", seen_floor);
  const Outcome run = gnomon("radiance floor.scene.json --on floor --quiet");
  ASSERT_THAT(lines(run.out), SizeIs(4)) << run.err;
  EXPECT_EQ(lines(run.out)[0], "x,y,z,nx,ny,nz,light,radiance,error_bound");
  EXPECT_THAT(lines(run.out)[1], StartsWith("0,0,0,0,0,1,bulb,0.318309886"));
  EXPECT_THAT(lines(gnomon("radiance floor.scene.json --on floor --shape 3,2 --quiet").out), SizeIs(1 + 3 * 6));
  EXPECT_THAT(lines(gnomon("radiance floor.scene.json --on floor --eye 0,0,-5 --quiet").out)[1],
              StartsWith("0,0,0,0,0,1,bulb,0,0"));
  EXPECT_THAT(lines(gnomon("radiance floor.scene.json --on floor --eye 0,0,0 --quiet").out)[3],
              StartsWith("0,0,0,0,0,1,total,0,0"));
  EXPECT_THAT(lines(gnomon("radiance floor.scene.json --on floor --material chalk --quiet").out)[1],
              StartsWith("0,0,0,0,0,1,bulb,0.1591549"));
}

TEST_F(RadianceCommand, WantsAnEyeForAReceiverAndOneSourceOfPoints) {
  write("grey.scene.json", scene_with(""));
  write("floor.scene.json", seen_floor);
  EXPECT_EQ(gnomon("radiance floor.scene.json --at views.csv --on floor").code, 2);
  EXPECT_EQ(gnomon("radiance floor.scene.json").code, 2);
  EXPECT_EQ(gnomon("radiance floor.scene.json --at views.csv --eye 0,0,1").code, 2);
  EXPECT_THAT(gnomon("radiance floor.scene.json --on floor --eye 0,1").err, HasSubstr("expected x,y,z"));
  EXPECT_THAT(gnomon("radiance floor.scene.json --on ceiling").err, HasSubstr("it has 'floor'"));
}

}  // namespace
}  // namespace gnomon
