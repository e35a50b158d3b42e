#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class IrradianceCommand : public Program {
 protected:
  IrradianceCommand() {
    write("table.scene.json", table_scene);
    write("lamps.scene.json", R"({"gnomon": 1, "dimension": 3, "blockers": [], "lights": [
      {"name": "bulb", "shape": "point", "position": [0, 3, 4], "intensity": 50},
      {"name": "tube", "shape": "segment", "vertices": [[0, 0, 2], [0, 0, 4]], "intensity_per_length": 4}]})");
  }
};

TEST_F(IrradianceCommand, TellsValueAndBoundOfEveryLightPointByPoint) {
  write("points.csv", "x,y,z,nx,ny,nz,label\n0,0,0,0,0,2,a\n0,0,0,0,0,-1,b\n");
  const Outcome run = gnomon("irradiance lamps.scene.json --at points.csv --json result.json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(lines(run.out),
              ElementsAre("x,y,z,nx,ny,nz,label,light,irradiance,error_bound", StartsWith("0,0,0,0,0,2,a,bulb,1.6"),
                          StartsWith("0,0,0,0,0,2,a,tube,1,"), "0,0,0,0,0,-1,b,bulb,0,0", "0,0,0,0,0,-1,b,tube,0,0"));
  const json result = read_json("result.json");
  EXPECT_EQ(result["schema"], "gnomon/irradiance/1");
  const json& bulb = result["points"][0]["lights"][0];
  EXPECT_LE(std::fabs(bulb["irradiance"].get<double>() - 1.6), bulb["error_bound"].get<double>());
  EXPECT_EQ(result["point_count"], 2);
}

TEST_F(IrradianceCommand, GivesARowForEachPointOnRequest) {
  write("points.csv", "x,y,z,nx,ny,nz,label\n0,0,0,0,0,2,a\n0,0,0,0,0,-1,b\n");
  const std::string start = "irradiance lamps.scene.json --at points.csv ";
  EXPECT_THAT(lines(gnomon(start + "--sum").out), ElementsAre("x,y,z,nx,ny,nz,label,irradiance,error_bound",
                                                              StartsWith("0,0,0,0,0,2,a,2.6"), "0,0,0,0,0,-1,b,0,0"));
  EXPECT_THAT(lines(gnomon(start + "--wide").out),
              ElementsAre("x,y,z,nx,ny,nz,label,irradiance_bulb,error_bound_bulb,irradiance_tube,error_bound_tube",
                          testing::MatchesRegex("0,0,0,0,0,2,a,1\\.6[^,]*,[^,]+,1,[^,]+"), "0,0,0,0,0,-1,b,0,0,0,0"));
  EXPECT_THAT(lines(gnomon(start + "--wide --sum").out)[0],
              testing::EndsWith("error_bound_tube,irradiance,error_bound"));
  const json sum = json::parse(gnomon(start + "--sum --json -").out)["points"][0]["sum"];
  EXPECT_LE(std::fabs(sum["irradiance"].get<double>() - 2.6), sum["error_bound"].get<double>());
}

TEST_F(IrradianceCommand, WritesSensorFilesThatItReadsAndAValueALine) {
  write("points.csv", "label,x,y,z,nx,ny,nz\na,0.1,0,0,0,0,2\nb,0,0,x,0,0,1\nc,-1,0.5,0,0,0,-1\n");
  const Outcome run = gnomon("irradiance lamps.scene.json --at points.csv --sum --sensors p.pts --values e.txt");
  EXPECT_EQ(run.code, 3);  // a line is malformed
  EXPECT_EQ(read("p.pts"), "0.1 0 0 0 0 2\n-1 0.5 0 0 0 -1\n");
  const Outcome again = gnomon("irradiance lamps.scene.json --at p.pts --sum --sensors q.pts --values f.txt");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(read("q.pts"), read("p.pts"));
  EXPECT_EQ(read("f.txt"), read("e.txt"));
  const std::vector<std::string> rows = lines(again.out), values = lines(read("f.txt"));
  ASSERT_EQ(rows.size(), 3u);
  ASSERT_EQ(values.size(), 2u);
  EXPECT_THAT(rows[1], HasSubstr("," + values[0] + ","));
  EXPECT_EQ(values[1], "0");
}

TEST_F(IrradianceCommand, RefusesSensorFilesThatAreReadOrWrittenTwice) {
  write("p.pts", "0 0 0 0 0 1\n");
  const auto expect = [&](const std::string& options, const std::string& text) {
    const Outcome run = gnomon("irradiance lamps.scene.json --at p.pts " + options);
    EXPECT_EQ(run.code, 2) << options;
    EXPECT_THAT(run.err, HasSubstr(text)) << options;
  };
  expect("--sensors p.pts", "is read");
  expect("--sensors a.pts --values ./a.pts", "another option");
  expect("--out a.csv --values a.csv", "a file of text");
  expect("--values -", "does not go to stdout");
  expect("--out a --values a", "another option");
  EXPECT_EQ(read("p.pts"), "0 0 0 0 0 1\n");
}

TEST_F(IrradianceCommand, TellsMeanLeastAndLargestWithBounds) {
  write("points.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,2\n0,0,0,0,0,-1\n");
  const Outcome run = gnomon("irradiance lamps.scene.json --at points.csv --out e.csv --json e.json");
  EXPECT_THAT(run.out, testing::AllOf(HasSubstr("2 points"), HasSubstr("mean"), HasSubstr("bulb"), HasSubstr("0.8 +- "),
                                      HasSubstr("\n  all ")));
  const json summary = read_json("e.json")["summary"];
  const auto expect = [](const json& found, double value) {
    EXPECT_LE(std::fabs(found["irradiance"].get<double>() - value), found["error_bound"].get<double>() + 1e-300);
  };
  expect(summary["lights"][0]["mean"], 0.8);
  expect(summary["lights"][0]["largest"], 1.6);
  expect(summary["sum"]["mean"], 1.3);
  expect(summary["sum"]["least"], 0);
}

/// A bulb 2 above a floor of two materials to choose from, in coloured light, and a camera.
const std::string seen_plain = R"({"gnomon": 1, "dimension": 3, "blockers": [], "ambient_radiance": 2, CAMERA
  "materials": [{"name": "chalk", "ambient": 0.5}, {"name": "lacquer", "diffuse": 0, "specular": 1, "exponent": 0}],
  "lights": [{"name": "bulb", "shape": "point", "position": [0, 0, 2], "intensity": 4 COLOUR}],
  "receivers": [{"name": "plain", "shape": "polygon", "material": "chalk",
                 "vertices": [[-1,-1,0], [1,-1,0], [1,1,0], [-1,1,0]]}]})";

std::string seen_plain_with(const std::string& camera, const std::string& colour) {
  std::string text = seen_plain;
  text.replace(text.find("CAMERA"), 6, camera);
  text.replace(text.find(" COLOUR"), 7, colour);
  return text;
}

TEST_F(IrradianceCommand, TellsRadianceBesideItWhereThereIsAnEye) {
  write("plain.scene.json", seen_plain_with(R"("camera": {"eye": [0, 3, 5], "look_at": [0, 0, 0]},)", ""));
  const std::string start = "irradiance plain.scene.json --on plain --eye camera ";
  const std::vector<std::string> rows = lines(gnomon(start + "--json e.json").out);
  EXPECT_EQ(rows[0], "x,y,z,nx,ny,nz,light,irradiance,error_bound,radiance,radiance_error_bound");
  EXPECT_THAT(rows[1], testing::MatchesRegex("0,0,0,0,0,1,bulb,1,[^,]+,0\\.1591549[^,]*,[^,]+"));
  const json result = read_json("e.json");
  EXPECT_EQ(result["material"], "chalk");
  EXPECT_EQ(result["points"][0]["eye"], json({0, 3, 5}));
  EXPECT_EQ(result["points"][0]["ambient"]["radiance"], json({1, 1, 1}));
  EXPECT_THAT(lines(gnomon(start + "--sum").out)[1],
              testing::MatchesRegex("0,0,0,0,0,1,1,[^,]+,1\\.1591549[^,]*,[^,]+"));
  EXPECT_EQ(lines(gnomon(start + "--wide").out)[0],
            "x,y,z,nx,ny,nz,irradiance_bulb,error_bound_bulb,radiance_bulb,radiance_error_bound_bulb");
  EXPECT_THAT(lines(gnomon(start + "--material lacquer").out)[1], HasSubstr(",0.318309886"));
}

TEST_F(IrradianceCommand, TellsTheVeryNumbersOfRadiance) {
  write("plain.scene.json", seen_plain_with("", R"(, "color": [1, 0.5, 0])"));
  write("points.csv", "x,y,z,nx,ny,nz\n0.3,0,0,0,0.1,1\n");
  write("views.csv", "x,y,z,nx,ny,nz,ex,ey,ez\n0.3,0,0,0,0.1,1,1,2,3\n");
  const std::string material = " --material chalk";
  const std::string beside = lines(gnomon("irradiance plain.scene.json --at points.csv --eye 1,2,3" + material).out)[1];
  const std::string alone = lines(gnomon("radiance plain.scene.json --at views.csv" + material).out)[1];
  const std::string numbers = alone.substr(alone.find("bulb,") + 5);
  EXPECT_THAT(beside, testing::EndsWith(numbers));
  EXPECT_THAT(lines(gnomon("irradiance plain.scene.json --at points.csv --eye 1,2,3" + material).out)[0],
              HasSubstr("radiance_r,radiance_error_bound_r,radiance_g,"));
}

TEST_F(IrradianceCommand, WantsAnEyeForAMaterialAndAMaterialAmongSeveral) {
  write("plain.scene.json", seen_plain_with("", ""));
  write("points.csv", "x,y,z,nx,ny,nz\n0.3,0,0,0,0.1,1\n");
  EXPECT_EQ(gnomon("irradiance plain.scene.json --on plain --material chalk").code, 2);
  EXPECT_THAT(gnomon("irradiance plain.scene.json --on plain --eye camera").err, HasSubstr("has no camera"));
  EXPECT_THAT(gnomon("irradiance plain.scene.json --on plain --eye 1,2").err, HasSubstr("found '1,2'"));
  EXPECT_THAT(gnomon("irradiance plain.scene.json --at points.csv --eye 1,2,3").err, HasSubstr("several materials"));
}

TEST_F(IrradianceCommand, RefusesAReceiverWhoseGridOverflows) {
  write("wide.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "bulb", "shape": "point", "position": [0, 0, 2], "intensity": 4}], "blockers": [],
    "receivers": [{"name": "plain", "shape": "polygon",
                   "vertices": [[-1e308, -1e308, 0], [1e308, -1e308, 0], [1e308, 1e308, 0], [-1e308, 1e308, 0]]}]})");
  const Outcome run = gnomon("irradiance wide.scene.json --on plain --shape 3,3");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("receiver 'plain' is wider than doubles go"));
}

TEST_F(IrradianceCommand, NothingArrivesInTheUmbra) {
  write("points.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,1\n");
  EXPECT_THAT(lines(gnomon("irradiance table.scene.json --at points.csv").out),
              ElementsAre(HasSubstr("irradiance"), "0,0,0,0,0,1,lamp,0,0"));
}

TEST_F(IrradianceCommand, ReportsMalformedLinesProcessesTheRestAndEndsWith3) {
  write("bad.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,0\n0,0,0,0,0,1\n");
  const Outcome run = gnomon("irradiance table.scene.json --at bad.csv");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(lines(run.out), testing::SizeIs(2));
  EXPECT_THAT(lines(run.err), ElementsAre("gnomon: bad.csv:2: nx,ny,nz: found 0,0,0, expected a direction"));
}

TEST_F(IrradianceCommand, RefusesPointsWithoutNormalsAndScenesOfThePlane) {
  write("points.csv", "x,y,z\n0,0,0\n");
  const Outcome run = gnomon("irradiance table.scene.json --at points.csv");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("expected the header \"x,y,z,nx,ny,nz\""));
  write("plane.scene.json", R"({"gnomon": 1, "dimension": 2, "lights": [], "blockers": []})");
  EXPECT_EQ(gnomon("irradiance plane.scene.json --at points.csv").code, 4);
}

class IrradianceOnAReceiver : public IrradianceCommand {
 protected:
  IrradianceOnAReceiver() {
    write("room.scene.json", R"({"gnomon": 1, "dimension": 3,
      "lights": [{"name": "bulb", "shape": "point", "position": [0, 0, 2], "intensity": 4}],
      "blockers": [{"name": "floor", "shape": "polygon", "vertices": [[-2,-1,0], [2,-1,0], [2,1,0], [-2,1,0]]}],
      "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[-2,-1,0], [2,-1,0], [2,1,0], [-2,1,0]]},
                    {"name": "ceiling", "shape": "polygon", "vertices": [[-2,-1,0], [-2,1,0], [2,1,0], [2,-1,0]]}]})");
  }
};

TEST_F(IrradianceOnAReceiver, SpreadsPointsInTheMiddlesOfCells) {
  const Outcome run = gnomon("irradiance room.scene.json --on floor --shape 3,1");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(lines(run.out),
              ElementsAre("x,y,z,nx,ny,nz,light,irradiance,error_bound", StartsWith("-1.33333333333333"),
                          StartsWith("0,0,0,0,0,1,bulb,1,"), StartsWith("1.33333333333333")));
  EXPECT_THAT(run.err, HasSubstr("receiver \"ceiling\": it is turned from every light"));
}

TEST_F(IrradianceOnAReceiver, AsksAtTheMeanOfTheCornersWithoutAShape) {
  EXPECT_THAT(lines(gnomon("irradiance room.scene.json --on floor").out),
              ElementsAre(HasSubstr("irradiance"), StartsWith("0,0,0,0,0,1,bulb,1,")));
}

TEST_F(IrradianceOnAReceiver, CountsLightFromItsFrontAlone) {
  EXPECT_THAT(lines(gnomon("irradiance room.scene.json --on ceiling --shape 1,1").out),
              ElementsAre(HasSubstr("irradiance"), "0,0,0,0,0,-1,bulb,0,0"));
}

TEST_F(IrradianceOnAReceiver, WritesFilesAndJson) {
  const Outcome run = gnomon("irradiance room.scene.json --on floor --shape 40,40 --out floor.csv --json floor.json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(lines(read("floor.csv")), testing::SizeIs(1601));
  EXPECT_EQ(read_json("floor.json")["point_count"], 1600);
}

TEST_F(IrradianceOnAReceiver, CountsPointsOnATerminalUnlessTheRowsGoThereOrItIsToBeQuiet) {
  // Whoever is at the other end of a pipe holds the program up until the line is there, or for a minute.
  write("wait.sh", "for i in $(seq 600); do grep -q \"$1\" terminal && exit 0; sleep 0.1; done; exit 1\n");
  const auto on_terminal = [&](const std::string& command) {
    write("command.sh", command);
    shell("export GNOMON; script -qfec 'sh command.sh' terminal > all.txt 2>&1");
    return read("terminal");
  };
  const std::string asked = "\"$GNOMON\" irradiance room.scene.json ";
  EXPECT_THAT(on_terminal(asked + "--on floor --shape 60,60 | { sh wait.sh ' of 3600, '; cat > floor.csv; }"),
              HasSubstr(" of 3600, "));
  EXPECT_THAT(on_terminal("{ echo x,y,z,nx,ny,nz; sh wait.sh 'point 0'; } | " + asked + "--at - --out floor.csv"),
              HasSubstr("point 0"));
  EXPECT_THAT(on_terminal(asked + "--on floor --shape 600,600 --out floor.csv --quiet"),
              testing::Not(HasSubstr(" of 360000, ")));
  EXPECT_THAT(on_terminal(asked + "--on floor --shape 600,600"), testing::Not(HasSubstr(" of 360000, ")));
}

TEST_F(IrradianceOnAReceiver, RefusesUnknownReceiversAndMissingOrBadShapes) {
  const Outcome unknown = gnomon("irradiance room.scene.json --on wall --shape 2,2");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("--on: the scene has no receiver 'wall'; it has 'floor', 'ceiling'"));
  for (const std::string arguments : {"--shape 2,2", "", "--on floor --shape 2", "--on floor --shape 2,0",
                                      "--on floor --shape 2,2 --at points.csv"}) {
    EXPECT_EQ(gnomon("irradiance room.scene.json " + arguments).code, 2) << arguments;
  }
}

TEST_F(IrradianceCommand, SaysTheSameWithAnyNumberOfThreads) {
  std::string points = "x,y,z,nx,ny,nz\n";
  for (int i = 0; i < 3000; ++i) points += std::to_string(i % 13 - 6) + ',' + std::to_string(i % 7) + ",0,0,0,1\n";
  write("many.csv", points);
  const std::string one = gnomon("irradiance table.scene.json --at many.csv --threads 1").out;
  EXPECT_EQ(one, gnomon("irradiance table.scene.json --at many.csv --threads 3").out);
  EXPECT_THAT(lines(one), testing::SizeIs(3001));
}

}  // namespace
}  // namespace gnomon
