#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class PlaceCommand : public Program {
 protected:
  PlaceCommand() {
    for (const char* name : {"desk.scene.json", "desk.goals.json", "desk_ceiling.goals.json",
                             "desk_conflict.goals.json", "desk_bright.goals.json", "overhang.scene.json",
                             "overhang.goals.json", "figure_5_35.scene.json", "figure_5_35.goals.json"}) {
      std::ifstream file(std::string(GNOMON_EXAMPLES "/") + name);
      write(name, std::string(std::istreambuf_iterator<char>(file), {}));
    }
  }

  json placed(const std::string& arguments) const {
    const Outcome run = gnomon("place " + arguments + " --json place.json");
    EXPECT_EQ(run.code, 0) << run.err;
    return read_json("place.json");
  }

  /// What is said of the desk's goals with one text in place of another.
  Outcome with_goals(const std::string& from, const std::string& to) const {
    std::string text = read("desk.goals.json");
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    write("changed.goals.json", text.replace(at, from.size(), to));
    return gnomon("place desk.scene.json --goals changed.goals.json");
  }
};

TEST_F(PlaceCommand, PlacesTheLampOfTheExample) {
  const json result = placed("desk.scene.json --goals desk.goals.json");
  EXPECT_EQ(result["status"], "feasible");
  EXPECT_EQ(result["answer"]["position"], json::parse("[7.5, 3, 24]"));
  EXPECT_EQ(result["answer"]["exact"], json::parse(R"(["15/2", "3", "24"])"));
  EXPECT_EQ(result["answer"]["margin"], 1.5);
  EXPECT_EQ(result["answer"]["representable"], true);
  EXPECT_EQ(result["region"]["size"]["exact"], "3");
  EXPECT_EQ(result["goals"][0]["region"], "umbra");
  EXPECT_EQ(result["goals"][0]["slack"]["double"], 1.5);
  EXPECT_EQ(result["goals"][0]["plane"],
            json::parse(R"({"goal": "pillow", "subject": 0, "blocker": "shelf", "edge": 3})"));
  EXPECT_EQ(result["conflict"], nullptr);
}

TEST_F(PlaceCommand, TellsPeopleWhereAndHowFar) {
  const Outcome run = gnomon("place desk.scene.json --goals desk.goals.json");
  EXPECT_THAT(run.out, AllOf(HasSubstr("feasible"), HasSubstr("7.5, 3, 24, at least 1.5 from every boundary"),
                             HasSubstr("length 3 (exactly 3)"), HasSubstr("yes (umbra)")));
  for (const std::string& line : lines(run.out)) EXPECT_LE(line.size(), 80U) << line;
}

TEST_F(PlaceCommand, TellsWhichGoalsCollideAndFailsOnlyIfAsked) {
  const json result = placed("desk.scene.json --goals desk_conflict.goals.json");
  EXPECT_EQ(result["status"], "infeasible");
  EXPECT_EQ(result["conflict"]["goals"], json::parse(R"(["pillow", "page"])"));
  EXPECT_EQ(gnomon("place desk.scene.json --goals desk_conflict.goals.json").code, 0);
  EXPECT_EQ(gnomon("place desk.scene.json --goals desk_conflict.goals.json --expect feasible").code, 5);
  EXPECT_EQ(gnomon("place desk.scene.json --goals desk.goals.json --expect feasible").code, 0);
}

TEST_F(PlaceCommand, ChecksAGivenPosition) {
  const json good = placed("desk.scene.json --goals desk.goals.json --check 7,3,24");
  EXPECT_EQ(good["status"], "feasible");
  EXPECT_EQ(good["region"], nullptr);
  const json bad = placed("desk.scene.json --goals desk.goals.json --check 5,3,24");
  EXPECT_EQ(bad["status"], "infeasible");
  EXPECT_EQ(bad["goals"][0]["satisfied"], false);
  EXPECT_EQ(bad["goals"][0]["slack"]["double"], -1);
  EXPECT_EQ(bad["goals"][1]["satisfied"], true);
  EXPECT_EQ(gnomon("place desk.scene.json --goals desk.goals.json --check 5,3,24 --expect feasible").code, 5);
}

TEST_F(PlaceCommand, WritesCellsWallsGoalsAndAnswerForParaView) {
  const Outcome run = gnomon("place desk.scene.json --goals desk_ceiling.goals.json --out design");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(read("design/design.vtm"), AllOf(HasSubstr("feasible"), HasSubstr("goals"), HasSubstr("answer")));
  EXPECT_THAT(read("design/design/feasible/surface.vtp"), AllOf(HasSubstr("goal_id"), HasSubstr("facet_kind")));
  for (const char* file : {"feasible/cells.vtu", "goals/pillow.vtp", "goals/desk.vtp", "answer.vtp", "ball.vtp"}) {
    EXPECT_TRUE(exists(std::string("design/design/") + file)) << file;
  }
  EXPECT_EQ(gnomon("place desk.scene.json --goals desk_conflict.goals.json --out design").code, 0);
  EXPECT_EQ(gnomon("place desk.scene.json --goals desk.goals.json --out design.vtm").code, 2);
}

TEST_F(PlaceCommand, MovesABlocker) {
  const json result = placed("overhang.scene.json --goals overhang.goals.json");
  EXPECT_EQ(result["variable"], json::parse(R"({"blocker": "board", "free": "translation"})"));
  EXPECT_EQ(result["answer"]["exact"], json::parse(R"(["0", "0", "21/4"])"));
}

TEST_F(PlaceCommand, MeetsTwoNails) {
  const json result = placed("figure_5_35.scene.json --goals figure_5_35.goals.json");
  EXPECT_EQ(result["answer"]["position"], json::parse("[0, 0, 4]"));
  EXPECT_EQ(result["region"]["dimension"], 0);
}

TEST_F(PlaceCommand, MakesTheDeskBrightEnough) {
  const json result = placed("desk.scene.json --goals desk_bright.goals.json");
  EXPECT_EQ(result["answer"]["exact"][0], "6");
  EXPECT_NEAR(result["goals"][3]["irradiance"]["double"], 24000 / (621 * std::sqrt(621)), 1e-12);
  EXPECT_EQ(result["goals"][3]["satisfied"], true);
  EXPECT_EQ(result["remarks"].size(), 1U);
  const json brightest = placed("desk.scene.json --goals desk.goals.json --choose brightest");
  EXPECT_EQ(brightest["answer"]["exact"][0], "6");
}

TEST_F(PlaceCommand, TakesTheNearestPlace) {
  const json result = placed("desk.scene.json --goals desk_ceiling.goals.json --choose nearest --near 0,0,24");
  EXPECT_EQ(result["answer"]["position"], json::parse("[6, 0, 24]"));
}

TEST_F(PlaceCommand, RefusesGoalsByPlaceNameFoundAndExpected) {
  const auto expect = [&](const std::string& from, const std::string& to, const std::string& pointer,
                          const std::string& words, int code = 3) {
    const Outcome run = with_goals(from, to);
    EXPECT_EQ(run.code, code) << to << '\n' << run.err;
    EXPECT_THAT(run.err, AllOf(HasSubstr("changed.goals.json: " + pointer), HasSubstr(words))) << to;
  };
  expect("\"lamp\"", "\"lmap\"", "/variable/light", "\"lamp\"");
  expect("\"shelf\"", "\"shelf#7\"", "/goals/0/by: goal \"pillow\"", "found the string \"shelf#7\"");
  expect("\"on\": \"desk\"", "\"on\": \"bench\"", "/goals/1/on: goal \"desk\"", "\"bed\", \"desk\"");
  expect("\"want\": \"lit\"", "\"want\": \"bright\"", "/goals/1/want", "\"no_reflection\"");
  expect("\"want\": \"lit\"", "\"want\": \"penumbra\"", "/goals/1/want", "without a size");
  expect("\"want\": \"lit\"", "\"want\": \"nail\"", "/goals/1/by", "no such key");
  expect("\"want\": \"dark\"", "\"want\": \"edge\", \"edge\": 4", "/goals/0/edge", "from 0 to 3");
  expect("\"want\": \"dark\"", "\"want\": \"nail\", \"vertex\": 0.5", "/goals/0/vertex", "the number 0.5");
  expect("[-3, 3, 8]", "[-3, 3, -8]", "/goals/2/eye", "behind the receiver");
  expect("[-3, 3, 8]", "[-3, 3]", "/goals/2/eye", "an array of 2");
  expect("\"at\": [18, 3, 0]", "\"at\": [18, 3, 0], \"on\": \"desk\"", "/goals/0", "\"at\" and \"on\"");
  expect("\"free\": \"position\"", "\"free\": \"direction\"", "/variable/free", "has a place");
  expect("\"free\": \"position\"", "\"free\": \"rotation\"", "/variable/free", "not turned", 4);
  expect("\"light\": \"lamp\"", "\"light\": \"lamp\", \"blocker\": \"shelf\"", "/variable/blocker", "one variable");
  expect("\"segment\"", "\"ring\"", "/domain/shape", "\"polyline\"");
  expect("[24, 3, 24]", "[0, 3, 24]", "/domain/vertices", "the same point twice");
  expect("\"segment\"", "\"polygon\"", "/domain/vertices", "no convex polygon");
  expect("\"segment\"", "\"polytope\"", "/domain/vertices", "without a volume");
  expect("\"goals\"", "\"margin\": -1, \"goals\"", "/margin", "at least 0");
  expect("\"goals\"", "\"margin\": 1e999, \"goals\"", "", "expected");
  expect("\"want\": \"lit\"", "\"want\": \"irradiance\"", "/goals/1/at_least", "no such key");
  expect("\"want\": \"lit\"", "\"want\": \"irradiance\", \"at_least\": -1", "/goals/1/at_least", "the number -1");
  expect("\"want\": \"lit\"", "\"want\": \"highlight\", \"eye\": [0, 0, 9]", "/goals/1/want", "its normal");
  expect("\"want\": \"dark\", \"by\": \"shelf\"",
         "\"normal\": [0, 0, 1], \"want\": \"highlight\", \"eye\": [0, 0, 9], \"contour\": [1, 1, 0], \"threshold\": 1",
         "/goals/0/threshold", "between 0 and 1");
  expect("\"segment\", \"vertices\": [[0, 3, 24], [24, 3, 24]]", "\"interval\", \"min\": 1, \"max\": 2", "/domain",
         "an interval");
  expect("\"want\": \"lit\"", "\"want\": \"lit\", \"whole\": false", "/goals/1/whole", "in part", 4);
  expect("\"gnomon_goals\": 1", "\"gnomon_goals\": 2", "/gnomon_goals", "the number 2");
  expect("\"name\": \"desk\"", "\"name\": \"pillow\"", "/goals/1/name", "again");
  expect("\"name\": \"desk\"", "\"name\": \"desk\", \"colour\": 1", "/goals/1/colour", "unknown key");
}

TEST_F(PlaceCommand, RefusesOptionsThatMakeNoSense) {
  const std::string start = "place desk.scene.json --goals desk.goals.json ";
  EXPECT_EQ(gnomon(start + "--near 1,2,3").code, 2);
  EXPECT_EQ(gnomon(start + "--choose nearest").code, 2);
  EXPECT_EQ(gnomon(start + "--choose best").code, 2);
  EXPECT_EQ(gnomon(start + "--choose nearest --near 1,nan,3").code, 2);
  EXPECT_EQ(gnomon(start + "--check 1,2").code, 2);
  EXPECT_EQ(gnomon(start + "--expect dark").code, 2);
  EXPECT_EQ(gnomon(start + "--json desk.goals.json").code, 2);
  EXPECT_EQ(gnomon("place desk.scene.json").code, 2);
  EXPECT_EQ(gnomon("place desk.scene.json --goals nothing.goals.json").code, 3);
  EXPECT_EQ(gnomon("place examples/figure_4_17.scene.json --goals desk.goals.json").code, 4);
}

TEST_F(PlaceCommand, RunsItsOwnExamples) {
  const std::vector<std::string> examples = examples_of(gnomon("place --help").out);
  EXPECT_EQ(examples.size(), 2U);
  for (const std::string& example : examples) EXPECT_EQ(gnomon(example).code, 0) << example;
}

TEST_F(PlaceCommand, SaysWhatItCannotDo) {
  std::string text = read("desk.goals.json");
  const std::size_t from = text.find("  \"domain\""), to = text.find('\n', from);
  write("free.goals.json", text.erase(from, to - from + 1));
  const Outcome run = gnomon("place desk.scene.json --goals free.goals.json");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("unbounded"));
  EXPECT_EQ(gnomon("place desk.scene.json --goals desk_ceiling.goals.json --max-cells 1").code, 0);
}

}  // namespace
}  // namespace gnomon
