#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class SunlightCommand : public Program {};

const std::string start = "sunlight examples/dial.scene.json --at examples/dial.csv ";

TEST_F(SunlightCommand, TellsTheHoursOfTheDial) {
  const Outcome run = gnomon(start + "--latitude 36.86989764584402 --declination 0 --json sun.json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(lines(run.out)[0], "x,y,z,nx,ny,nz,hours,error_bound,intervals");
  EXPECT_EQ(lines(run.out).size(), 4U);
  const json result = read_json("sun.json");
  EXPECT_EQ(result["time"], "local solar");
  // On the line of three o'clock the style's shadow comes at three.
  const json& intervals = result["points"][0]["intervals"];
  EXPECT_NEAR(intervals[0]["to"]["hour"], 15, 1e-12);
  EXPECT_EQ(intervals[0]["to"]["name"], json::parse(R"({"blocker": "style", "edge": 2})"));
  EXPECT_EQ(intervals[0]["from"]["name"], "horizon");
  EXPECT_NEAR(result["points"][2]["intervals"][0]["from"]["hour"], 9, 1e-12);
}

TEST_F(SunlightCommand, TakesADayOfTheYear) {
  write("p.csv", "0,0,0\n");
  const Outcome run = gnomon("sunlight examples/overhang.scene.json --at p.csv --latitude 52.5 --day 172 --json -");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NEAR(json::parse(run.out)["declination"], 23.44, 0.01);
}

TEST_F(SunlightCommand, WritesATableAndReportsBadLines) {
  write("p.csv", "x,y,z\n1,2,3\n1,2\n");
  const Outcome run = gnomon("sunlight examples/dial.scene.json --at p.csv --latitude 10 --declination 5 --out o.csv");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("p.csv:3"));
  EXPECT_THAT(run.out, HasSubstr("1 point"));
  EXPECT_EQ(lines(read("o.csv")).size(), 2U);
}

TEST_F(SunlightCommand, RefusesWhatMakesNoSense) {
  EXPECT_EQ(gnomon(start + "--latitude 91 --day 3").code, 2);
  EXPECT_EQ(gnomon(start + "--latitude 50").code, 0);
  EXPECT_EQ(gnomon(start + "--latitude 50 --day 3 --declination 2").code, 2);
  EXPECT_EQ(gnomon(start + "--latitude 50 --declination 24").code, 2);
  EXPECT_EQ(gnomon(start + "--latitude 50 --day 367").code, 2);
  EXPECT_EQ(gnomon(start + "--latitude 50 --day 3 --north 0,1,1").code, 2);
  EXPECT_EQ(gnomon(start + "--latitude 50 --day 3 --north 0,0,0").code, 2);
  EXPECT_EQ(gnomon(start + "--latitude 50 --day 3 --north 1,0,0").code, 0);
  EXPECT_EQ(gnomon("sunlight examples/figure_4_17.scene.json --at examples/dial.csv --latitude 5 --day 3").code, 4);
  EXPECT_EQ(gnomon("sunlight examples/dial.scene.json --at none.csv --latitude 5 --day 3").code, 3);
}

TEST_F(SunlightCommand, RunsItsOwnExamples) {
  const std::vector<std::string> examples = examples_of(gnomon("sunlight --help").out);
  EXPECT_EQ(examples.size(), 2U);
  for (const std::string& example : examples) EXPECT_EQ(gnomon(example).code, 0) << example;
}

}  // namespace
}  // namespace gnomon
