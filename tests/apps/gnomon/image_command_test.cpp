#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

/// A white floor under a sun that gives it pi.
std::string floor_under(const std::string& lights, const std::string& camera = R"("camera": {"eye": [0, -3, 3],
    "look_at": [0, 0, 0], "width": 8, "height": 6},)") {
  return R"({"gnomon": 1, "dimension": 3, "blockers": [], )" + camera + R"(
    "materials": [{"name": "white", "diffuse": 1}], "lights": [)" +
         lights + R"(],
    "receivers": [{"name": "floor", "shape": "polygon", "material": "white",
                   "vertices": [[-9,-9,0], [9,-9,0], [9,9,0], [-9,9,0]]}]})";
}

const std::string sun = R"({"name": "sun", "shape": "direction", "direction": [0,0,-1],
  "irradiance": 3.141592653589793, "color": [1, 0.5, 0]})";

class ImageCommand : public Program {
 protected:
  ImageCommand() { write("floor.scene.json", floor_under(sun)); }
};

TEST_F(ImageCommand, WritesRadianceAsFloatsRowsFromTheBottom) {
  const Outcome run = gnomon("image floor.scene.json --out floor.pfm --json floor.json");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string text = read("floor.pfm"), head = "PF\n8 6\n-1.0\n";
  ASSERT_EQ(text.size(), head.size() + 8 * 6 * 3 * 4);
  EXPECT_EQ(text.substr(0, head.size()), head);
  float rgb[3];
  std::memcpy(rgb, text.data() + head.size(), sizeof rgb);
  EXPECT_FLOAT_EQ(rgb[0], 1);
  EXPECT_FLOAT_EQ(rgb[1], 0.5);
  EXPECT_EQ(rgb[2], 0);
  const json result = read_json("floor.json");
  EXPECT_EQ(result["schema"], "gnomon/image/1");
  EXPECT_EQ(result["rays"], 48);
  EXPECT_EQ(result["answers"], 48);
  EXPECT_EQ(result["elements"], json::array({"floor"}));
  EXPECT_LT(result["worst_error_bound"].get<double>(), 1e-14);
  EXPECT_EQ(result["unbounded_pixels"], 0);
  EXPECT_NEAR(result["exposure"].get<double>(), 0.8 / (0.2126 + 0.5 * 0.7152), 1e-12);
}

TEST_F(ImageCommand, WritesPngAndVtkImagesThatAreTheSameForAnyNumberOfThreads) {
  for (const std::string ending : {"png", "vti", "pfm"}) {
    ASSERT_EQ(gnomon("image examples/still_life.scene.json --out a." + ending + " --threads 1 --quiet").code, 0);
    ASSERT_EQ(gnomon("image examples/still_life.scene.json --out b." + ending + " --threads 3 --quiet").code, 0);
    EXPECT_EQ(read("a." + ending), read("b." + ending)) << ending;
  }
  EXPECT_EQ(read("a.png").substr(1, 3), "PNG");
  for (const std::string name : {"radiance", "radiance_error_bound", "irradiance", "depth", "element_id", "facet_id"}) {
    EXPECT_THAT(read("a.vti"), HasSubstr("Name=\"" + name + "\""));
  }
}

TEST_F(ImageCommand, RefusesWhatItCannotMean) {
  write("blind.scene.json", floor_under(sun, ""));
  const Outcome blind = gnomon("image blind.scene.json --out a.png");
  EXPECT_EQ(blind.code, 3);
  EXPECT_THAT(blind.err, AllOf(HasSubstr("no camera"), HasSubstr("look_at")));
  write("plane.scene.json", R"({"gnomon": 1, "dimension": 2, "lights": [], "blockers": []})");
  EXPECT_EQ(gnomon("image plane.scene.json --out a.png").code, 4);
  for (const std::string wrong :
       {"--out a.jpg", "--out -", "--out a.png --shading gouraudd", "--out a.png --lights points",
        "--out a.png --lights points:0", "--out a.png --exposure 0", "--out a.png --samples 0"}) {
    EXPECT_EQ(gnomon("image floor.scene.json " + wrong).code, 2) << wrong;
  }
  EXPECT_FALSE(exists("a.png"));
}

/// The middle of the picture shows where a tube comes out of the floor.
TEST_F(ImageCommand, TellsPixelsWithoutABound) {
  const std::string tube = R"({"name": "tube", "shape": "segment", "vertices": [[0,0,-1], [0,0,1]]})";
  write("tube.scene.json", floor_under(tube, R"("camera": {"eye": [0, 0, 4], "look_at": [0, 0, 0], "up": [0, 1, 0],
    "width": 3, "height": 3},)"));
  const Outcome run = gnomon("image tube.scene.json --out tube.png --json tube.json");
  EXPECT_THAT(run.out, HasSubstr("but 1 pixel without a bound")) << run.err;
  EXPECT_EQ(read_json("tube.json")["unbounded_pixels"], 1);
}

/// A fold of no thickness: at its corners normals cancel.
TEST_F(ImageCommand, WarnsOfFacetsWhoseNormalsCancel) {
  write("fold.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\nf 1 3 2\n");
  std::string scene = floor_under(sun);
  const std::string none = R"("blockers": [])";
  scene.replace(scene.find(none), none.size(),
                R"("blockers": [{"name": "fold", "shape": "mesh", "file": "fold.obj", "normals": "equal"}])");
  write("fold.scene.json", scene);
  const Outcome run = gnomon("image fold.scene.json --out fold.png --quiet");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("normals cancel at corners of 2 facets, shaded flat"));
}

TEST_F(ImageCommand, TellsSizeSecondsExposureAndTheWorstBound) {
  EXPECT_THAT(gnomon("image floor.scene.json --out a.png --exposure 0.5").out,
              AllOf(HasSubstr("8 x 6 pixels"), HasSubstr("exposure 0.5"), HasSubstr("no pixel off by more than")));
}

}  // namespace
}  // namespace gnomon
