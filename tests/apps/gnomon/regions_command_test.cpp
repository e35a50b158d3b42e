#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// The umbra of table_scene has the half width 3 on the floor, the occlusion 5.
class RegionsCommand : public Program {
 protected:
  RegionsCommand() {
    write("table.scene.json", table_scene);
    write("points.csv", "x,y,z\n0,0,0\n4,0,0\n6,0,0\n0,0,5\n");
  }
};

TEST_F(RegionsCommand, TellsRegionFractionAndBoundOfEveryPoint) {
  const Outcome run = gnomon("regions table.scene.json --at points.csv");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  EXPECT_THAT(lines(run.out),
              ElementsAre("x,y,z,light,region,visible_fraction,error_bound", "0,0,0,lamp,umbra,0,0",
                          StartsWith("4,0,0,lamp,penumbra,0.5,"), "6,0,0,lamp,lit,1,0", "0,0,5,lamp,unlit,0,0"));
}

TEST_F(RegionsCommand, RunsPointByPointAndLightsInFileOrder) {
  write("mixed.scene.json", mixed_scene);
  write("two.csv", "x,y,z\n5.25,0.25,-1\n0,0,0\n");
  EXPECT_THAT(lines(gnomon("regions mixed.scene.json --at two.csv").out),
              ElementsAre("x,y,z,light,region,visible_fraction,error_bound", HasSubstr("5.25,0.25,-1,lamp,"),
                          "5.25,0.25,-1,sun,umbra,0,0", "0,0,0,lamp,umbra,0,0", "0,0,0,sun,umbra,0,0"));
  EXPECT_THAT(lines(gnomon("regions mixed.scene.json --at two.csv --light sun").out),
              ElementsAre("x,y,z,light,region,visible_fraction,error_bound", "5.25,0.25,-1,sun,umbra,0,0",
                          "0,0,0,sun,umbra,0,0"));
}

TEST_F(RegionsCommand, TellsTheSameInThePlaneBehindAllSegmentsTogether) {
  write("roof.scene.json", R"({"gnomon": 1, "dimension": 2,
    "lights": [{"name": "tube", "shape": "segment", "vertices": [[-1, 4], [1, 4]]}],
    "blockers": [{"name": "roof", "shape": "polyline", "vertices": [[-1, 2], [0, 2.5], [1, 2]]}]})");
  write("plane.csv", "x,y\n0,1\n-1.5,0\n5,1\n");
  EXPECT_THAT(lines(gnomon("regions roof.scene.json --at plane.csv").out),
              ElementsAre("x,y,light,region,visible_fraction,error_bound", "0,1,tube,umbra,0,0",
                          HasSubstr("-1.5,0,tube,penumbra,0.25,"), "5,1,tube,lit,1,0"));
}

TEST_F(RegionsCommand, EchoesFieldsAsTheyWereWritten) {
  write("written.csv", "x, y,z,label\r\n 4.00,-0,0e5,\"a, b\"\r\n");
  EXPECT_THAT(lines(gnomon("regions table.scene.json --at written.csv").out),
              ElementsAre("x, y,z,label,light,region,visible_fraction,error_bound",
                          StartsWith(" 4.00,-0,0e5,\"a, b\",lamp,penumbra,0.5,")));
}

TEST_F(RegionsCommand, ReportsMalformedLinesByNumberProcessesTheRestAndEndsWith3) {
  write("bad.csv", "x,y,z\n0,0,0\n1,2\n\nzero,0,0\n6,0,0\n");
  const Outcome run = gnomon("regions table.scene.json --at bad.csv");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(lines(run.out), ElementsAre("x,y,z,light,region,visible_fraction,error_bound", "0,0,0,lamp,umbra,0,0",
                                          "6,0,0,lamp,lit,1,0"));
  EXPECT_THAT(lines(run.err), ElementsAre("gnomon: bad.csv:3: found 2 fields, expected 3",
                                          "gnomon: bad.csv:5: x: found \"zero\", expected a finite number"));
}

TEST_F(RegionsCommand, ReadsStandardInput) {
  const Outcome run = gnomon("regions table.scene.json --at - < points.csv");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, gnomon("regions table.scene.json --at points.csv").out);
}

TEST_F(RegionsCommand, WritesFilesAndTellsTheCounts) {
  const std::string csv = gnomon("regions table.scene.json --at points.csv").out;
  const Outcome run = gnomon("regions table.scene.json --at points.csv --out result.csv --json result.json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("4 points"), HasSubstr("penumbra")));
  EXPECT_EQ(read("result.csv"), csv);
  json result = read_json("result.json");
  EXPECT_EQ(result["schema"], "gnomon/regions/1");
  EXPECT_LE(result["points"][1]["lights"][0]["error_bound"], 1e-12);
  result["points"][1]["lights"][0]["error_bound"] = 0.0;
  EXPECT_EQ(result["points"][1], json::parse(R"({"line": 3, "point": [4.0, 0.0, 0.0], "lights": [
      {"light": "lamp", "region": "penumbra", "visible_fraction": 0.5, "error_bound": 0.0}]})"));
  EXPECT_EQ(result["lights"], json::parse(R"([{"name": "lamp", "lit": 1, "penumbra": 1, "umbra": 1, "unlit": 1}])"));
  EXPECT_THAT(gnomon("regions table.scene.json --at points.csv --out result.csv --quiet").out, IsEmpty());
}

TEST_F(RegionsCommand, PrintsTheJsonAloneOnStandardOutputWithMalformedLinesInIt) {
  write("bad.csv", "x,y,z\n0,0\n");
  const Outcome run = gnomon("regions table.scene.json --at bad.csv --json -");
  EXPECT_EQ(run.code, 3);
  const json result = json::parse(run.out);
  EXPECT_EQ(result["points"], json::parse(R"([{"line": 2, "problem": "found 2 fields, expected 3"}])"));
  EXPECT_EQ(result["malformed_lines"], 1);
}

TEST_F(RegionsCommand, SaysTheSameWithAnyNumberOfThreadsAndAcrossBatches) {
  std::string points = "x,y,z\n";
  for (int i = 0; i < 3000; ++i) points += std::to_string(i % 97 / 8.0) + ",0.5,0\n";
  write("many.csv", points);
  const Outcome one = gnomon("regions table.scene.json --at many.csv --threads 1");
  EXPECT_EQ(lines(one.out).size(), 3001U);
  EXPECT_EQ(gnomon("regions table.scene.json --at many.csv --threads 7").out, one.out);
}

TEST_F(RegionsCommand, KnowsSolidsConcavePolygonsAndMeshes) {
  write("l.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  write("shapes.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "sun", "shape": "direction", "direction": [0,0,-1]}],
    "blockers": [
      {"name": "mesh", "shape": "mesh", "file": "l.obj"},
      {"name": "post", "shape": "polytope", "vertices": [[5,0,0], [6,0,0], [5,1,0], [5,0,2]]},
      {"name": "board", "shape": "concave_polygon",
       "vertices": [[10,0,1], [12,0,1], [12,1,1], [11,1,1], [11,2,1], [10,2,1]]}]})");
  write("shapes.csv", "x,y,z\n0.125,0.125,0.125\n0.5,0.5,-1\n0.75,0.75,-1\n5.25,0.25,0.125\n11.5,1.5,0\n10.5,1.5,0\n");
  const Outcome run = gnomon("regions shapes.scene.json --at shapes.csv");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(lines(run.out),
              ElementsAre("x,y,z,light,region,visible_fraction,error_bound", "0.125,0.125,0.125,sun,umbra,0,0",
                          "0.5,0.5,-1,sun,umbra,0,0", "0.75,0.75,-1,sun,lit,1,0", "5.25,0.25,0.125,sun,umbra,0,0",
                          "11.5,1.5,0,sun,lit,1,0", "10.5,1.5,0,sun,umbra,0,0"));
}

TEST_F(RegionsCommand, QuotesNamesOfLightsWhereCsvAsksForIt) {
  write("named.scene.json", R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "a \"big\", bright sun", "shape": "direction", "direction": [0,0,-1]}], "blockers": []})");
  EXPECT_THAT(gnomon("regions named.scene.json --at points.csv").out,
              HasSubstr("0,0,0,\"a \"\"big\"\", bright sun\",lit,1,0\n"));
}

TEST_F(RegionsCommand, RefusesWhatItCannotUse) {
  EXPECT_EQ(gnomon("regions table.scene.json").code, 2);
  EXPECT_EQ(gnomon("regions --at points.csv").code, 2);
  EXPECT_THAT(gnomon("regions table.scene.json --at points.csv --light bulb").err,
              AllOf(HasSubstr("'bulb'"), HasSubstr("'lamp'")));
  EXPECT_EQ(gnomon("regions table.scene.json --at points.csv --light bulb").code, 2);
  EXPECT_EQ(gnomon("regions table.scene.json --at missing.csv").code, 3);
  EXPECT_EQ(gnomon("regions missing.scene.json --at points.csv").code, 3);
  EXPECT_EQ(gnomon("regions table.scene.json --at examples").code, 3);
  write("header.csv", "a,b,c\n");
  EXPECT_THAT(gnomon("regions table.scene.json --at header.csv").err,
              AllOf(HasSubstr("header.csv:1"), HasSubstr("\"a,b,c\""), HasSubstr("\"x,y,z\"")));
  EXPECT_EQ(gnomon("regions table.scene.json --at points.csv >/dev/full").code, 1);
}

TEST_F(RegionsCommand, NeverWritesOverWhatItReads) {
  const std::string scene = read("table.scene.json");
  const std::string points = read("points.csv");
  for (const std::string place : {"--out points.csv", "--out ./examples/../points.csv", "--json table.scene.json"}) {
    const Outcome run = gnomon("regions table.scene.json --at points.csv " + place);
    EXPECT_EQ(run.code, 2) << place;
    EXPECT_THAT(run.err, HasSubstr("this file is read; expected another one to write")) << place;
  }
  for (const std::string command : {"check", "shadow", "receivers", "discontinuities"}) {
    EXPECT_EQ(gnomon(command + " table.scene.json --json table.scene.json").code, 2) << command;
  }
  EXPECT_THAT(gnomon("shadow table.scene.json --out result --json result/./manifest.json").err,
              HasSubstr("the folder's list of files has this name"));
  EXPECT_EQ(read("table.scene.json"), scene);
  EXPECT_EQ(read("points.csv"), points);
}

TEST_F(RegionsCommand, KeepsTheOldFileWhereTheNewOneCannotBeFinished) {
  write("result.csv", "old");
  write("header.csv", "a,b,c\n");
  EXPECT_EQ(gnomon("regions table.scene.json --at header.csv --out result.csv").code, 3);
  EXPECT_EQ(read("result.csv"), "old");
  EXPECT_THAT(names_in("."), Not(testing::Contains(testing::StartsWith(".gnomon"))));
}

}  // namespace
}  // namespace gnomon
