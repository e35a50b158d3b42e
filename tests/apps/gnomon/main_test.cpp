#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

TEST_F(Program, PrintsItsVersion) {
  const Outcome run = gnomon("--version");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, "gnomon " GNOMON_VERSION "\n");
  EXPECT_THAT(run.err, IsEmpty());
}

TEST_F(Program, HelpNamesEveryCommand) {
  for (const char* option : {"--help", "-h"}) {
    const Outcome run = gnomon(option);
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.out, AllOf(HasSubstr("shadow"), HasSubstr("check"), HasSubstr("regions"), HasSubstr("render"),
                               HasSubstr("Exit codes")));
    EXPECT_THAT(run.err, IsEmpty());
  }
}

TEST_F(Program, WithoutACommandPrintsHelpAsAMistake) {
  const Outcome run = gnomon("");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err, HasSubstr("Usage: gnomon COMMAND"));
}

TEST_F(Program, NamesAnUnknownCommandAndTheNearestKnownOne) {
  const Outcome run = gnomon("shaddow --out there");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err,
              AllOf(HasSubstr("'shaddow'"), HasSubstr("nearest is 'shadow'"),
                    HasSubstr("shadow, check, regions, grid, irradiance, discontinuities, receivers, render")));
}

TEST_F(Program, RefusesAnOptionInPlaceOfACommand) {
  const Outcome run = gnomon("--verbose");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("'--verbose'"));
}

TEST_F(Program, EveryHelpEndsWithTwoExamples) {
  std::vector<std::string> commands = commands_of(gnomon("--help").out);
  EXPECT_THAT(commands, testing::IsSupersetOf({"shadow", "check", "regions", "grid", "irradiance", "render"}));
  commands.emplace_back();
  for (const std::string& command : commands) {
    const std::string help = gnomon(command + " --help").out;
    EXPECT_THAT(examples_of(help), SizeIs(2)) << command;
    EXPECT_THAT(help.substr(help.find("Examples:")),
                testing::MatchesRegex("Examples:\n  gnomon [^\n]*\n  gnomon [^\n]*\n+"))
        << command;
  }
}

TEST_F(Program, HelpIsGivenWhereARequiredArgumentIsMissing) {
  EXPECT_EQ(gnomon("check --help").code, 0);
  EXPECT_EQ(gnomon("render -h").code, 0);
}

TEST_F(Program, PointsToTheHelpOfTheCommandThatWasMisused) {
  const Outcome run = gnomon("check");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("SCENE"), HasSubstr("Try 'gnomon check --help'")));
}

TEST_F(Program, FailsWhereStandardOutputCannotBeWritten) {
  for (const char* redirection : {">/dev/full", ">&-"}) {
    const Outcome run = gnomon(std::string("--help ") + redirection);
    EXPECT_EQ(run.code, 1) << redirection;
    EXPECT_THAT(run.err, HasSubstr("standard output"));
  }
}

TEST_F(Program, SurvivesAReaderThatGoesAway) {
  // A pipe whose reading end is closed before the program starts.
  const Outcome run = shell("mkfifo pipe; exec 3<>pipe; exec 4>pipe; exec 3<&-; \"$GNOMON\" --help >&4");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("standard output"));
}

TEST_F(Program, RunsWithAllStandardStreamsClosed) {
  write("table.scene.json", table_scene);
  const Outcome run = gnomon("shadow table.scene.json --quiet --json result.json <&- >&- 2>&-");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(read("result.json"), StartsWith("{"));
}

TEST_F(Program, UsesNoColorOffTheTerminal) {
  EXPECT_THAT(gnomon("shado").err, Not(HasSubstr("\033")));
}

}  // namespace
}  // namespace gnomon
