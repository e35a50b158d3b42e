#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::Each;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// A series whose files take long to write: a point light that moves along two thousand places.
std::string long_path() {
  std::string text = "x,y,z\n";
  for (int i = 0; i < 2000; ++i) text += "0,0," + std::to_string(4 + i) + "\n";
  return text;
}

class UntimelyEnd : public Program {
 protected:
  UntimelyEnd() {
    write("table.scene.json", table_scene);
    write("path.csv", long_path());
  }
};

TEST_F(UntimelyEnd, ASignalRemovesTheHiddenFoldersAndEndsTheProgramAsSignalsDo) {
  for (const auto& [name, number] : {std::pair("INT", 2), std::pair("TERM", 15), std::pair("HUP", 1)}) {
    const Outcome run =
        shell(R"(env --default-signal=INT "$GNOMON" shadow table.scene.json --path path.csv --out series --quiet &
      until ls -d series/.gnomon-*/shadow_0003 >/dev/null 2>&1; do kill -0 $! || exit 9; done
      kill -)" +
              std::string(name) + " $!; wait $!");
    EXPECT_EQ(run.code, 128 + number) << run.err;
    EXPECT_THAT(names_in("series"), IsEmpty()) << name;
    EXPECT_THAT(run.err, Not(HasSubstr("gnomon:"))) << name;
  }
}

TEST_F(UntimelyEnd, ASignalThatIsIgnoredStaysIgnored) {
  write("short.csv", "x,y,z\n0,0,4\n0,0,5\n");
  const Outcome run = shell(R"(trap '' HUP; "$GNOMON" shadow table.scene.json --path path.csv --out series --quiet &
    until ls -d series/.gnomon-*/shadow_0003 >/dev/null 2>&1; do kill -0 $! || exit 9; done
    kill -HUP $!; sleep 0.2; kill -0 $! && echo alive; kill -TERM $!; wait $!)");
  EXPECT_EQ(run.out, "alive\n");
  EXPECT_THAT(names_in("series"), IsEmpty());
}

#if defined(__SANITIZE_ADDRESS__)
#define GNOMON_NEEDS_ROOM 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define GNOMON_NEEDS_ROOM 1
#endif
#endif

#ifndef GNOMON_NEEDS_ROOM
/// Whatever there is room for: either the command does its work, or it says in a sentence that it could not.
TEST_F(UntimelyEnd, ALackOfMemoryIsASentence) {
  const std::string commands[] = {"receivers examples/cornell_box.scene.json --light ceiling_lamp --out out --quiet",
                                  "shadow examples/cornell_box.scene.json --out out --quiet",
                                  "grid table.scene.json --shape 400,400,400 --out grid.vti --quiet",
                                  "regions examples/cornell_box.scene.json --at examples/points.csv --out points.csv"};
  int told = 0;
  for (const std::string& command : commands) {
    for (int mebibytes = 100; mebibytes < 500; mebibytes += 100) {
      const Outcome run = shell("ulimit -v " + std::to_string(1024 * mebibytes) + "; \"$GNOMON\" " + command);
      if (run.code == 127) continue;  // no room for its libraries
      EXPECT_LE(run.code, 1) << command << " in " << mebibytes << " MiB: " << run.err;
      if (run.code == 1) {
        ++told;
        EXPECT_THAT(run.err, AllOf(StartsWith("gnomon: "), HasSubstr("memory"), EndsWith("\n")));
      }
      EXPECT_THAT(names_in("."), Each(Not(StartsWith(".gnomon"))));
    }
  }
  EXPECT_GT(told, 0);
}
#endif

}  // namespace
}  // namespace gnomon
