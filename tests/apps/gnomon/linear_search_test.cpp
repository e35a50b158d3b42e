#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::HasSubstr;

/// A tube above a block, a board that stands in line with it, and a slatted screen of 30 laths; a camera looks at all.
class LinearSearchOption : public Program {
 protected:
  LinearSearchOption() {
    std::string laths;
    for (int i = 0; i < 30; ++i) {
      const std::string x = std::to_string(i - 15);
      laths += R"(, {"name": "lath_)" + std::to_string(i) + R"(", "shape": "polygon", "vertices": [[)" + x +
               ",-3,2],[" + x + ".5,-3,2],[" + x + ".5,3,2.5],[" + x + ",3,2.5]]}";
    }
    write("tube.scene.json", R"({"gnomon": 1, "dimension": 3,
      "lights": [{"name": "tube", "shape": "segment", "vertices": [[-2, 0, 5], [2, 0.5, 5]]}],
      "blockers": [
        {"name": "block", "shape": "polytope", "vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]},
        {"name": "board", "shape": "polygon", "vertices": [[3,0,4],[3,2,4],[3,2,6],[3,0,6]]})" +
                                 laths + R"(],
      "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[-9,-9,0],[9,-9,0],[9,9,0],[-9,9,0]]}],
      "camera": {"eye": [3, -8, 4], "look_at": [0, 0, 0], "width": 24, "height": 16}})");
    write("points.csv", "x,y,z\n0,0,-1\n4,1,5\n-8,0,5\n2,0.5,5\n-6,0.25,3\n");
  }

  const std::vector<std::string> searches = {"plane",        "hierarchy",      "grid",           "grid=3",
                                             "light_buffer", "light_buffer=1", "light_hierarchy"};
};

TEST_F(LinearSearchOption, ChangesNoByteOfAnyAnswer) {
  for (const char* command : {"regions tube.scene.json --at points.csv --out out --quiet",
                              "grid tube.scene.json --shape 6,5,4 --out out.vti --quiet && mv out.vti out",
                              "irradiance tube.scene.json --on floor --shape 8,7 --out out --quiet",
                              "radiance tube.scene.json --on floor --shape 4,4 --eye 0,-9,4 --out out --quiet",
                              "image tube.scene.json --out out.pfm --quiet && mv out.pfm out"}) {
    const std::string text = command;
    const std::size_t name_end = text.find(' ');
    const auto answer = [&](const std::string& option) {
      const std::string with = text.substr(0, name_end) + option + text.substr(name_end);
      const Outcome run = shell("\"$GNOMON\" " + with);
      EXPECT_EQ(run.code, 0) << with << run.err;
      return read("out");
    };
    const std::string usual = answer("");
    EXPECT_FALSE(usual.empty()) << command;
    for (const std::string& search : searches) {
      EXPECT_EQ(answer(" --linear-search " + search), usual) << command << " " << search;
    }
  }
}

TEST_F(LinearSearchOption, RefusesWhatIsNoSearch) {
  const auto refusal = [&](const std::string& search) {
    const Outcome run = gnomon("regions tube.scene.json --at points.csv --linear-search " + search);
    EXPECT_EQ(run.code, 2) << search;
    return run.err;
  };
  EXPECT_THAT(refusal("octree"), HasSubstr("--linear-search octree: expected one of plane, hierarchy, grid[=N], "
                                           "light_buffer[=N], light_hierarchy"));
  EXPECT_THAT(refusal("grid=0"), HasSubstr("--linear-search grid=0: expected a whole number from 1 to 100 after '='"));
  EXPECT_THAT(refusal("grid=101"), HasSubstr("from 1 to 100"));
  EXPECT_THAT(refusal("grid=3x"), HasSubstr("from 1 to 100"));
  EXPECT_THAT(refusal("light_buffer="), HasSubstr("from 1 to 10000"));
  EXPECT_THAT(refusal("plane=3"), HasSubstr("'plane' takes no number"));
}

TEST_F(LinearSearchOption, IsForScenesOfSpace) {
  const Outcome run = gnomon("regions examples/figure_4_17.scene.json --at points.csv --linear-search plane");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("--linear-search is for scenes of space; this one is of the plane"));
}

}  // namespace
}  // namespace gnomon
