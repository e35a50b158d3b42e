#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// A lamp at some height above a row of small triangles: a result of some hundred files.
std::string row_scene(const std::string& height) {
  std::string text =
      R"({"gnomon": 1, "dimension": 3, "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[-1,-1,)" + height +
      "], [-1,1," + height + "], [1,1," + height + "], [1,-1," + height + "]]}], \"blockers\": [";
  for (int i = 0; i < 40; ++i) {
    const std::string x = std::to_string(i - 20);
    text += std::string(i == 0 ? "" : ",") + R"({"name": "b)" + std::to_string(i) +
            R"(", "shape": "polygon", "vertices": [[)" + x + ",0,1], [" + x + ".5,0,1], [" + x + ".5,0.5,1]]}";
  }
  return text + "]}";
}

class SharedFolder : public Program {
 protected:
  SharedFolder() {
    write("one.scene.json", row_scene("4"));
    write("two.scene.json", row_scene("5"));
    gnomon("shadow one.scene.json --out one --quiet");
    gnomon("shadow two.scene.json --out two --quiet");
    gnomon("shadow one.scene.json --out out --quiet");
  }

  bool is_whole(const std::string& result) const {
    return shell("diff -r --exclude='.gnomon-*' " + result + " out").code == 0;
  }
};

TEST_F(SharedFolder, AMixtureThatAKilledRunLeavesIsRefusedAndWrittenAgain) {
  int mixtures = 0;
  for (const std::string number : {"1", "2", "40", "150", "283", "284"}) {
    const Outcome killed = shell("LD_PRELOAD='" GNOMON_STOP_AT_RENAME "' KILL_AT=" + number +
                                 " \"$GNOMON\" shadow two.scene.json --out out");
    ASSERT_EQ(killed.code, 128 + 9) << number;
    const Outcome drawn = gnomon("render out --out picture.gltf");
    if (is_whole("one")) {
      EXPECT_EQ(drawn.code, 0) << drawn.err;
    } else {
      ++mixtures;
      EXPECT_EQ(drawn.code, 3) << number;
      EXPECT_THAT(drawn.err, AllOf(HasSubstr("another run"), HasSubstr("write the folder again")));
    }
    ASSERT_EQ(gnomon("shadow one.scene.json --out out --quiet").code, 0);
    EXPECT_TRUE(is_whole("one")) << number;
    EXPECT_THAT(names_in("out"), Each(Not(StartsWith(".gnomon"))));
  }
  EXPECT_EQ(mixtures, 5);
}

TEST_F(SharedFolder, OfTwoWritersTheLastResultIsThereWhole) {
  const Outcome run =
      shell("LD_PRELOAD='" GNOMON_STOP_AT_RENAME
            R"(' SLEEP_AT=100 AT_WORK=at_work GO_ON=go_on "$GNOMON" shadow one.scene.json --out out --quiet &
      first=$!
      until [ -L at_work ]; do kill -0 $first || exit 9; done
      "$GNOMON" shadow two.scene.json --out out --quiet & second=$!
      until ls -d out/.gnomon-$second-* >/dev/null 2>&1; do kill -0 $second || exit 8; done
      touch go_on
      wait $first && wait $second)");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(is_whole("two"));
}

TEST_F(SharedFolder, AWriterThatDoesNotEndIsNotWaitedForForEver) {
  const Outcome run =
      shell("LD_PRELOAD='" GNOMON_STOP_AT_RENAME
            R"(' SLEEP_AT=100 AT_WORK=at_work GO_ON=go_on "$GNOMON" shadow two.scene.json --out out --quiet &
      first=$!
      until [ -L at_work ]; do kill -0 $first || exit 9; done
      "$GNOMON" shadow one.scene.json --out out --quiet; echo "code $?"
      touch go_on
      wait $first)");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "code 1\n");
  EXPECT_THAT(run.err, AllOf(HasSubstr("another gnomon"), HasSubstr("out")));
  EXPECT_TRUE(is_whole("two"));
}

TEST_F(SharedFolder, CommandsLeaveEachOthersResults) {
  ASSERT_EQ(gnomon("shadow examples/figure_4_22.scene.json --out all --quiet").code, 0);
  ASSERT_EQ(gnomon("receivers examples/figure_4_22.scene.json --out all --quiet").code, 0);
  const Outcome run = gnomon("discontinuities examples/figure_4_22.scene.json --out all --quiet");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, IsEmpty());
  for (const std::string file : {"shadow.vtm", "receivers.vtm", "discontinuities.vtm"})
    EXPECT_TRUE(exists("all/" + file));
  EXPECT_FALSE(names_in("all/shadow/volumes").empty());
  EXPECT_FALSE(names_in("all/shadow/receivers").empty());
  EXPECT_EQ(gnomon("render all --out picture.gltf").code, 0);
  const Outcome other = gnomon("shadow one.scene.json --out all --quiet");
  EXPECT_EQ(other.code, 0);
  EXPECT_THAT(other.err, AllOf(HasSubstr("receivers.vtm"), HasSubstr("another scene or box")));
  EXPECT_TRUE(exists("all/receivers.vtm"));
}

TEST_F(SharedFolder, FilesOfOthersAreRefusedBeforeAnythingIsComputed) {
  for (const std::string command : {"shadow", "receivers", "discontinuities"}) {
    for (const std::string file : {"manifest.json", "view.py"}) {
      ASSERT_EQ(shell("rm -rf mine; mkdir mine; echo 'print(\"mine\")' > mine/" + file).code, 0);
      const Outcome run = gnomon(command + " examples/figure_4_22.scene.json --out mine");
      EXPECT_EQ(run.code, 1) << command;
      EXPECT_THAT(run.err, AllOf(HasSubstr(file), HasSubstr("not gnomon's"))) << command;
      EXPECT_EQ(read("mine/" + file), "print(\"mine\")\n") << command;
      EXPECT_EQ(names_in("mine").size(), 1u) << command;
    }
  }
}

}  // namespace
}  // namespace gnomon
