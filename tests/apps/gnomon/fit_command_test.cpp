#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class FitCommand : public Program {
 protected:
  Outcome with_paint(const std::string& text) const {
    write("p.paint.json", text);
    return gnomon("fit examples/two_lamps.scene.json --paint p.paint.json --json fit.json");
  }
};

const std::string intensities = R"({"gnomon_paint": 1, "fit": "intensities", "lights": ["left", "right"], "samples": )";
const std::string material = R"({"gnomon_paint": 1, "fit": "material", "exponent": 20, "samples": )";

TEST_F(FitCommand, TellsIntensitiesAndResiduals) {
  const Outcome run =
      with_paint(intensities + R"([{"at": [-2, 0, 0], "irradiance": 0.1}, {"at": [2, 0, 0], "irradiance": 0.2}]})");
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = read_json("fit.json");
  EXPECT_EQ(result["rank"], 2);
  EXPECT_GT(result["values"]["right"], result["values"]["left"]);
  for (const json& r : result["residuals"]) EXPECT_LT(std::fabs(r.get<double>()), 1e-15);
  EXPECT_THAT(run.out, AllOf(HasSubstr("left"), HasSubstr("residual")));
}

TEST_F(FitCommand, FitsColoursApart) {
  const Outcome run = with_paint(
      intensities +
      R"([{"at": [-2, 0, 0], "irradiance": [0.1, 0.2, 0]}, {"at": [2, 0, 0], "irradiance": [0.2, 0.1, 0]}]})");
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = read_json("fit.json");
  EXPECT_EQ(result["values"]["left"].size(), 3U);
  EXPECT_EQ(result["values"]["left"][2], 0);
}

TEST_F(FitCommand, NamesSamplesWhoseBoundsExcludeEachOther) {
  const Outcome run = with_paint(material + R"([{"at": [-2, 0, 0], "eye": [2, 0, 4], "between": [0.01, 0.02]},
    {"at": [2, 0, 0], "eye": [2, 0, 4], "between": [9, 10]}]})");
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = read_json("fit.json");
  EXPECT_EQ(result["feasible"], false);
  EXPECT_EQ(result["values"], nullptr);
  EXPECT_FALSE(result["conflict"].empty());
  EXPECT_THAT(run.out, HasSubstr("conflict"));
}

TEST_F(FitCommand, RefusesPaintByPlace) {
  const auto expect = [&](const std::string& text, const std::string& pointer, const std::string& words, int code = 3) {
    const Outcome run = with_paint(text);
    EXPECT_EQ(run.code, code) << text << run.err;
    EXPECT_THAT(run.err, AllOf(HasSubstr(pointer), HasSubstr(words)));
  };
  const std::string good = R"([{"at": [-2, 0, 0], "irradiance": 0.1}]})";
  expect(R"({"gnomon_paint": 1, "fit": "intensities", "lights": ["middle"], "samples": )" + good, "/lights/0",
         "\"right\"");
  expect(R"({"gnomon_paint": 1, "fit": "colours", "lights": ["left"], "samples": )" + good, "/fit", "\"material\"");
  expect(R"({"gnomon_paint": 1, "fit": "material", "exponent": 2.5, "samples": )" + good, "/exponent",
         "the number 2.5");
  expect(R"({"gnomon_paint": 1, "fit": "material", "samples": )" + good, "/exponent", "no such key");
  expect(intensities + R"([]})", "/samples", "no sample");
  expect(intensities + R"([{"at": [-2, 0, 1], "irradiance": 0.1}]})", "/samples/0/at", "no receiver");
  expect(intensities + R"([{"at": [-2, 0, 0], "irradiance": -1}]})", "/samples/0/irradiance", "the number -1");
  expect(intensities + R"([{"at": [-2, 0, 0], "irradiance": [1, 2]}]})", "/samples/0/irradiance", "an array of 2");
  expect(intensities + R"([{"at": [-2, 0, 0], "irradiance": 1}, {"at": [-2, 0, 0], "irradiance": [1, 2, 3]}]})",
         "/samples/1/irradiance", "as in the first");
  expect(material + R"([{"at": [-2, 0, 0], "eye": [0, 0, 1], "between": [2, 1]}]})", "/samples/0/between",
         "above the largest");
  expect(
      material +
          R"([{"at": [-2, 0, 0], "eye": [0, 0, 1], "between": [1, 2]}, {"at": [-2, 0, 0], "eye": [0, 0, 1], "radiance": 1}]})",
      "bounds", "all samples or none", 4);
  EXPECT_EQ(gnomon("fit examples/two_lamps.scene.json --paint none.json").code, 3);
  EXPECT_EQ(gnomon("fit examples/two_lamps.scene.json").code, 2);
}

TEST_F(FitCommand, RunsItsOwnExamples) {
  const std::vector<std::string> examples = examples_of(gnomon("fit --help").out);
  EXPECT_EQ(examples.size(), 2U);
  for (const std::string& example : examples) EXPECT_EQ(gnomon(example).code, 0) << example;
}

}  // namespace
}  // namespace gnomon
