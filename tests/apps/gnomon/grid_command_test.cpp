#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class GridCommand : public Program {
 protected:
  GridCommand() { write("table.scene.json", table_scene); }
};

TEST_F(GridCommand, WritesImageDataWithTheShapeAskedFor) {
  const Outcome run = gnomon("grid table.scene.json --shape 5,4,3 --box -6,-6,-1,6,6,3 --out grid.vti");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("60 points"));
  EXPECT_THAT(read("grid.vti").substr(0, 4000),
              testing::AllOf(HasSubstr("WholeExtent=\"0 4 0 3 0 2\""), HasSubstr("Name=\"region\""),
                             HasSubstr("Name=\"visible_fraction\""), HasSubstr("Name=\"error_bound\"")));
  EXPECT_THAT(gnomon("grid table.scene.json --shape 2,2,2 --out grid.vti --quiet").out, IsEmpty());
}

TEST_F(GridCommand, WritesTheSameWithAnyNumberOfThreads) {
  gnomon("grid table.scene.json --shape 9,9,9 --out one.vti --threads 1");
  gnomon("grid table.scene.json --shape 9,9,9 --out three.vti --threads 3");
  EXPECT_EQ(read("one.vti"), read("three.vti"));
}

/// A bulb 2 above the origin, and a material.
const std::string bulb_scene = R"({"gnomon": 1, "dimension": 3, "blockers": [], "ambient_radiance": 2,
  "camera": {"eye": [0, 3, 5], "look_at": [0, 0, 0]}, "materials": [{"name": "chalk", "ambient": 0.5}],
  "lights": [{"name": "bulb", "shape": "point", "position": [0, 0, 2], "intensity": 4}]})";

/// How the header of a file tells an array that is one number throughout.
std::string constant(const std::string& name, const std::string& number) {
  return "Name=\"" + name + "\".* RangeMin=\"" + number + " *\" *RangeMax=\"" + number + " *\"";
}

TEST_F(GridCommand, TellsIrradianceOfSurfacesAndRadianceToAnEye) {
  write("bulb.scene.json", bulb_scene);
  const std::string start = "grid bulb.scene.json --shape 1,1,1 --box=-1,-1,-1,1,1,1 --out grid.vti ";
  ASSERT_EQ(gnomon(start + "--normal 0,0,3").code, 0);
  EXPECT_THAT(read("grid.vti").substr(0, 4000), testing::ContainsRegex(constant("irradiance", "1")));
  EXPECT_THAT(read("grid.vti").substr(0, 4000), Not(HasSubstr("Name=\"radiance\"")));
  ASSERT_EQ(gnomon(start + "--normal 0,0,1 --eye camera").code, 0);
  const std::string header = read("grid.vti").substr(0, 4000);
  // Of vectors the range is that of their lengths: (1/2 pi + 1) sqrt(3).
  EXPECT_THAT(header, testing::ContainsRegex(constant("radiance", "2.00771[0-9]*")));
  EXPECT_THAT(header,
              testing::AllOf(HasSubstr("Name=\"radiance_error_bound\""), HasSubstr("NumberOfComponents=\"3\"")));
  ASSERT_EQ(gnomon(start + "--normal 0,0,-1").code, 0);
  EXPECT_THAT(read("grid.vti").substr(0, 4000), testing::ContainsRegex(constant("irradiance", "0")));
  EXPECT_THAT(read("grid.vti").substr(0, 4000), testing::ContainsRegex(constant("region", "3"))) << "unlit";
}

TEST_F(GridCommand, RefusesEyesWithoutASurfaceAndSurfacesInThePlane) {
  write("bulb.scene.json", bulb_scene);
  const auto refusal = [&](const std::string& options) {
    return gnomon("grid bulb.scene.json --shape 2,2,2 --out grid.vti " + options);
  };
  EXPECT_THAT(refusal("--eye camera").err, HasSubstr("goes with --normal"));
  EXPECT_THAT(refusal("--normal 0,0,1 --material chalk").err, HasSubstr("goes with --eye"));
  EXPECT_THAT(refusal("--normal 0,0").err, HasSubstr("found '0,0'"));
  EXPECT_THAT(refusal("--normal 0,0,0").err, HasSubstr("a vector that is not 0"));
  EXPECT_EQ(refusal("--normal 0,0,0").code, 2);
  EXPECT_EQ(gnomon("grid examples/figure_4_17.scene.json --shape 2,2,1 --normal 0,1,0 --out grid.vti").code, 4);
}

TEST_F(GridCommand, TakesTwoNumbersInThePlane) {
  write("plane.scene.json", R"({"gnomon": 1, "dimension": 2, "lights": [{"name": "lamp", "shape": "segment",
    "vertices": [[-1, 4], [1, 4]]}], "blockers": [{"name": "b", "shape": "segment", "vertices": [[-1, 2], [1, 2]]}]})");
  for (const std::string shape : {"4,3", "4,3,1"}) {
    const Outcome run = gnomon("grid plane.scene.json --out plane.vti --shape " + shape);
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("12 points"));
  }
  const Outcome run = gnomon("grid plane.scene.json --out plane.vti --shape 4,3,2");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("two positive whole numbers nx,ny in a scene of dimension 2"));
}

TEST_F(GridCommand, RefusesShapesThatAreNone) {
  for (const std::string shape : {"1,2", "0,1,1", "1,1,x", "1,1,1,1", "-1,1,1", "100000,100000,1"}) {
    const Outcome run = gnomon("grid table.scene.json --shape " + shape + " --out grid.vti");
    EXPECT_EQ(run.code, 2) << shape;
    EXPECT_THAT(run.err, HasSubstr(shape));
  }
}

TEST_F(Program, RefusesABoxWhoseDiagonalOverflows) {
  write("overflow.scene.json", table_scene);
  const Outcome run =
      gnomon("grid overflow.scene.json --shape 3,3,3 --box=-1e308,-1e308,-1e308,1e308,1e308,1e308 --out grid.vti");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, testing::HasSubstr("a diagonal that is a double"));
}

}  // namespace
}  // namespace gnomon
