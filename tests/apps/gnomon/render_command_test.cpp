#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class RenderCommand : public Program {
 protected:
  RenderCommand() {
    write("table.scene.json", table_scene);
    write("bent_shelf.scene.json", bent_shelf_scene);
  }
};

TEST_F(RenderCommand, SaysWhatToDoWithoutADisplay) {
  const Outcome run = gnomon("render table.scene.json --out table.png");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err, AllOf(HasSubstr("display"), HasSubstr("xvfb-run")));
  EXPECT_FALSE(exists("table.png"));
}

TEST_F(RenderCommand, NeedsASceneAndAFileForThePicture) {
  EXPECT_EQ(gnomon("render").code, 2);
  EXPECT_EQ(gnomon("render table.scene.json").code, 2);
  EXPECT_EQ(gnomon("render --out table.png").code, 2);
}

TEST_F(RenderCommand, RefusesASizeThatIsNone) {
  for (const std::string size :
       {"800", "800x", "x600", "800x600x3", "0x0", "-800x600", "800x1e3", "99999x99999", "''"}) {
    const Outcome run = gnomon("render table.scene.json --out table.png --size " + size);
    EXPECT_EQ(run.code, 2) << size;
    EXPECT_THAT(run.err, HasSubstr("--size")) << size;
  }
}

TEST_F(RenderCommand, EndsWith3ForAMissingSceneOrAFolderWithoutAResult) {
  EXPECT_EQ(gnomon("render missing.scene.json --out picture.png").code, 3);
  const Outcome run = gnomon("render examples --out picture.png");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("manifest.json"));
}

TEST_F(RenderCommand, EndsWith4WhereNoPairIsSupported) {
  EXPECT_EQ(gnomon("render bent_shelf.scene.json --out shelf.png").code, 4);
}

TEST_F(RenderCommand, RefusesToChoosePairsOfAFinishedResult) {
  ASSERT_EQ(gnomon("shadow table.scene.json --out shadows --quiet").code, 0);
  const Outcome run = gnomon("render shadows --light lamp --out shadows.png");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("--light"));
}

}  // namespace
}  // namespace gnomon
