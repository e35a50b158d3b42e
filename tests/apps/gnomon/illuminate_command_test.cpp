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

/// A lamp over a desk that a box stands on, in centimetres.
class IlluminateCommand : public Program {
 protected:
  IlluminateCommand() {
    write("desk.scene.json", R"({"gnomon": 1, "dimension": 3, "length_unit": "cm", "materials": [{"name": "oak",
      "diffuse": [0.5, 0.25, 0.125]}], "lights": [
      {"name": "lamp", "shape": "polygon", "radiance": 2, "vertices": [[-10,-10,90], [-10,10,90], [10,10,90], [10,-10,90]]},
      {"name": "bulb", "shape": "point", "intensity": 0.5, "position": [60,0,100]}], "blockers": [{"name": "box",
      "shape": "polytope", "vertices": [[0,0,0], [20,0,0], [20,20,0], [0,20,0], [0,0,10], [20,0,10], [20,20,10], [0,20,10]]}],
      "receivers": [{"name": "desk", "shape": "polygon", "material": "oak",
      "vertices": [[-50,-50,0], [50,-50,0], [50,50,0], [-50,50,0]]}]})");
  }
};

TEST_F(IlluminateCommand, TellsOfTheMeshesAsJsonThatFollowsItsSchema) {
  const Outcome run = gnomon("illuminate desk.scene.json --faces --json mesh.json");
  ASSERT_EQ(run.code, 0) << run.err;
  const json found = read_json("mesh.json");
  ASSERT_EQ(found["receivers"].size(), 7U);
  for (const json& receiver : found["receivers"]) {
    EXPECT_EQ(receiver["unmet"]["faces"], 0) << receiver;
    EXPECT_LE(receiver["largest_error"].get<double>(), found["tolerance"].get<double>());
  }
  EXPECT_NEAR(found["receivers"][0]["area"].get<double>(), 10000, 1e-9);
  EXPECT_THAT(run.out, AllOf(HasSubstr("desk"), HasSubstr("box/facet#5"), HasSubstr("tolerance")));
}

TEST_F(IlluminateCommand, MeasuresInMetres) {
  // Below a bulb alone, 1 m away: 0.5 W/m^2.
  ASSERT_EQ(gnomon("illuminate desk.scene.json --light bulb --tolerance 0.001 --json mesh.json").code, 0);
  const json desk = read_json("mesh.json")["receivers"][0];
  EXPECT_NEAR(desk["largest"]["irradiance"].get<double>(), 0.5 / std::pow(1.01, 1.5), 1e-4);
  EXPECT_LT(desk["flux"]["value"].get<double>(), 0.5);
  EXPECT_GT(desk["flux"]["value"].get<double>(), 0.1);
  EXPECT_LE(desk["flux"]["error"].get<double>(), 0.001);
}

TEST_F(IlluminateCommand, WritesATreeForParaView) {
  for (const std::string order : {"1", "2"}) {
    const Outcome run = gnomon("illuminate desk.scene.json --order " + order + " --out out --format vtm,vtpc");
    ASSERT_EQ(run.code, 0) << run.err;
    const std::string ending = order == "1" ? "vtp" : "vtu";
    const std::string faces = read("out/shadow/illumination/desk." + ending);
    for (const std::string array : {"irradiance", "irradiance_bound", "irradiance_lamp", "irradiance_bulb",
                                    "radiosity_direct", "error", "unmet", "face_id"}) {
      EXPECT_THAT(faces, HasSubstr("Name=\"" + array + "\""));
    }
    EXPECT_THAT(read("out/shadow/illumination_edges/desk.vtp"), HasSubstr("Name=\"discontinuity_order\""));
    EXPECT_THAT(read("out/illumination.vtm"), HasSubstr("desk." + ending));
    EXPECT_TRUE(exists("out/illumination.vtpc"));
    EXPECT_EQ(read_json("out/manifest.json")["command"], "illumination");
  }
  // The second result has taken the place of the first.
  EXPECT_FALSE(exists("out/shadow/illumination/desk.vtp"));
}

TEST_F(IlluminateCommand, RefusesWhatItCannotDoNamingIt) {
  EXPECT_EQ(gnomon("illuminate desk.scene.json --tolerance 0").code, 2);
  EXPECT_EQ(gnomon("illuminate desk.scene.json --relative nan").code, 2);
  EXPECT_EQ(gnomon("illuminate desk.scene.json --order 3").code, 2);
  EXPECT_EQ(gnomon("illuminate desk.scene.json --tolerance 1 --relative 0.1").code, 2);
  EXPECT_THAT(gnomon("illuminate desk.scene.json --split some").err, HasSubstr("'some', expected need, all or none"));
  EXPECT_THAT(gnomon("illuminate desk.scene.json --receiver table").err, HasSubstr("no receiver 'table'"));
  write("plane.scene.json", R"({"gnomon": 1, "dimension": 2, "lights": [], "blockers": []})");
  EXPECT_EQ(gnomon("illuminate plane.scene.json").code, 4);
}

TEST_F(IlluminateCommand, WarnsOfFacesThatAreUnmet) {
  const Outcome run = gnomon("illuminate desk.scene.json --relative 0.0001 --max-faces 50 --json mesh.json");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("did not get within the tolerance"));
  EXPECT_GT(read_json("mesh.json")["receivers"][0]["unmet"]["faces"], 0);
}

}  // namespace
}  // namespace gnomon
