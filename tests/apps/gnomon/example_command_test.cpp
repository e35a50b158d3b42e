#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST_F(Program, ExampleListsWhatIsInstalled) {
  const Outcome run = gnomon("example");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(StartsWith("boxes "), HasSubstr("\nfigure_4_22 "), HasSubstr("\npoints.csv ")));
  EXPECT_THAT(run.out, HasSubstr("in the plane"));
}

TEST_F(Program, ExamplePrintsAScene) {
  for (const std::string name : {"figure_4_22", "figure_4_22.scene.json"}) {
    const Outcome run = gnomon("example " + name);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.out, read("examples/figure_4_22.scene.json"));
    EXPECT_THAT(run.err, IsEmpty());
  }
  EXPECT_EQ(gnomon("example points.csv").out, read("examples/points.csv"));
}

TEST_F(Program, EveryExampleCanBePrintedAndScenesChecked) {
  const Outcome run = shell(R"("$GNOMON" example | sed 's/ .*//' | while read -r name; do
    "$GNOMON" example "$name" --out copies >/dev/null || echo "$name"; done
    for scene in copies/*.scene.json; do "$GNOMON" check "$scene" --quiet || echo "$scene"; done)");
  EXPECT_EQ(run.out, "");
  for (const std::string& line : lines(run.err)) {
    // The papers' cylinders are open, one of their scenes has no blocker, and boxes have dark sides.
    EXPECT_THAT(line, AnyOf(HasSubstr("/phong_"), HasSubstr("/p93_3_8"), HasSubstr("/boxes"))) << line;
  }
  EXPECT_TRUE(exists("copies/letter_block.stl"));
  EXPECT_TRUE(exists("copies/s14.scene.json"));
}

TEST_F(Program, ExampleSaysWhatASceneNeedsBesideIt) {
  const Outcome run = gnomon("example letter_block");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("letter_block.stl"));
  ASSERT_EQ(gnomon("example letter_block --out here").code, 0);
  EXPECT_THAT(names_in("here"), ElementsAre("letter_block.scene.json", "letter_block.stl"));
}

TEST_F(Program, ExamplesInFoldersAreListedAndCopiedWithAllTheirMeshes) {
  EXPECT_THAT(gnomon("example").out, AllOf(HasSubstr("\npapers/phong_1_7 "), HasSubstr("\ntheory/s14 ")));
  EXPECT_EQ(gnomon("example phong_1_7").out, read("examples/papers/phong_1_7.scene.json"));
  ASSERT_EQ(gnomon("example papers/phong_1_7 --out here").code, 0);
  EXPECT_THAT(names_in("here"),
              ElementsAre("phong_1_7.scene.json", "phong_cylinder_1_7_12.obj", "phong_cylinder_1_7_3.obj",
                          "phong_cylinder_1_7_4.obj", "phong_cylinder_1_7_8.obj"));
}

TEST_F(Program, ExampleReplacesNothingThatIsNotTheSame) {
  ASSERT_EQ(gnomon("example points.csv --out here").code, 0);
  EXPECT_EQ(gnomon("example points.csv --out here").code, 0);
  write("here/points.csv", "mine");
  const Outcome run = gnomon("example points.csv --out here");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("here/points.csv"));
  EXPECT_EQ(read("here/points.csv"), "mine");
}

TEST_F(Program, ExampleNamesTheNearestOfThoseThatThereAre) {
  const Outcome run = gnomon("example cornel_box");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("'cornel_box'"), HasSubstr("'cornell_box'")));
  EXPECT_EQ(gnomon("example ../../bin/gnomon").code, 2);
}

}  // namespace
}  // namespace gnomon
