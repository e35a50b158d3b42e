#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;

class DiscontinuitiesCommand : public Program {
 protected:
  DiscontinuitiesCommand() { write("table.scene.json", table_scene); }
};

TEST_F(DiscontinuitiesCommand, NamesTheSurfacesOfAPairAsTheoryCountsThem) {
  const Outcome run = gnomon("discontinuities table.scene.json --json -");
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = json::parse(run.out);
  EXPECT_EQ(result["schema"], "gnomon/discontinuities/1");
  ASSERT_EQ(result["lights"].size(), 1U);
  const json& surfaces = result["lights"][0]["surfaces"];
  // 4 x 4 of light vertices and table edges, as many the other way round: theory E6, coplanar ones not merged.
  EXPECT_EQ(surfaces.size(), 32U);
  std::map<std::string, int> extremal;
  for (const json& surface : surfaces) {
    ++extremal[surface.value("extremal", "none")];
    EXPECT_THAT(surface["vertex"]["of"].get<std::string>(), testing::AnyOf("light:lamp", "blocker:table"));
    // Each edge is parallel to one of the light's edges, and lies with both ends of it in a plane.
    EXPECT_EQ(surface["order"], 1);
  }
}

TEST_F(DiscontinuitiesCommand, WritesSurfacesByOrder) {
  ASSERT_EQ(gnomon("discontinuities table.scene.json --out surfaces").code, 0);
  EXPECT_TRUE(exists("surfaces/discontinuities.vtm"));
  EXPECT_TRUE(exists("surfaces/shadow/discontinuities/lamp/d1.vtp"));
}

TEST_F(DiscontinuitiesCommand, WantsSomewhereToWrite) {
  EXPECT_EQ(gnomon("discontinuities table.scene.json").code, 2);
}

TEST_F(DiscontinuitiesCommand, RunsItsOwnExamples) {
  const std::vector<std::string> examples = examples_of(gnomon("discontinuities --help").out);
  ASSERT_FALSE(examples.empty());
  for (const std::string& example : examples) EXPECT_EQ(gnomon(example).code, 0) << example;
}

}  // namespace
}  // namespace gnomon
