#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

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

TEST_F(Program, VersionIsThatOfTheCitationAndTheChangelog) {
  EXPECT_EQ(shell("grep '^version: ' \"$(realpath examples)/../CITATION.cff\"").out, "version: " GNOMON_VERSION "\n");
  EXPECT_EQ(shell("grep -c '^## .*" GNOMON_VERSION "' \"$(realpath examples)/../CHANGELOG.md\"").out, "1\n");
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
  EXPECT_THAT(run.err, AllOf(HasSubstr("'shaddow'"), HasSubstr("nearest is 'shadow'"),
                             HasSubstr("shadow, check, regions, grid, irradiance, radiance, discontinuities, "
                                       "receivers, illuminate, view-factors, place, sunlight, fit, render")));
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

/// The first line that is wider than a terminal.
std::string wide_line(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > 80) return line;
  }
  return "";
}

TEST_F(Program, HelpAndTablesAreAtMost80ColumnsWide) {
  std::vector<std::string> commands = commands_of(gnomon("--help").out);
  commands.emplace_back();
  for (const std::string& command : commands) EXPECT_EQ(wide_line(gnomon(command + " --help").out), "") << command;
  write("mixed.scene.json", mixed_scene);
  write("bent.scene.json", bent_lamp_scene);
  for (const std::string words :
       {"check mixed.scene.json", "check bent.scene.json", "check examples/cornell_box.scene.json", "example",
        "shadow mixed.scene.json --out out", "shadow examples/cornell_box.scene.json --out out",
        "shadow examples/figure_4_19.scene.json --out out", "receivers examples/figure_4_22.scene.json",
        "irradiance examples/figure_4_22.scene.json --on floor --shape 3,3 --out e.csv",
        "regions examples/cornell_box.scene.json --at examples/points.csv --out r.csv"}) {
    EXPECT_EQ(wide_line(gnomon(words).out), "") << words;
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

TEST_F(Program, EndsQuietlyWhenItsReaderHasReadEnough) {
  write(
      "points.csv", "x,y,z\n" + [] {
        std::string rows;
        for (int i = 0; i < 20000; ++i) rows += std::to_string(i) + ",0,0\n";
        return rows;
      }());
  write("table.scene.json", table_scene);
  // A pipe whose reading end is closed before the program starts, and one that is closed while it writes.
  for (const std::string words : {"--help", "check table.scene.json", "shadow table.scene.json --json -",
                                  "regions table.scene.json --at points.csv"}) {
    const Outcome closed =
        shell("rm -f pipe; mkfifo pipe; exec 3<>pipe; exec 4>pipe; exec 3<&-; \"$GNOMON\" " + words + " >&4");
    EXPECT_EQ(closed.code, 0) << words;
    EXPECT_THAT(closed.err, IsEmpty()) << words;
    const Outcome cut = shell("{ \"$GNOMON\" " + words + "; echo \"code $?\" >&2; } | head -n 1 >/dev/null");
    EXPECT_EQ(cut.err, "code 0\n") << words;
  }
}

TEST_F(Program, WritesAFileThoughNobodyReadsStdoutAnyMore) {
  write("table.scene.json", table_scene);
  write("points.csv", "x,y,z\n0,0,0\n");
  const Outcome run = shell(
      "mkfifo pipe; exec 3<>pipe; exec 4>pipe; exec 3<&-;"
      "\"$GNOMON\" regions table.scene.json --at points.csv --json seen.json >&4");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(read_json("seen.json")["point_count"], 1);
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

TEST_F(Program, NamesTheNearestOfAnUnknownOption) {
  const Outcome run = gnomon("shadow --ouut folder");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, testing::HasSubstr("unknown option '--ouut'; the nearest is '--out'"));
  EXPECT_THAT(gnomon("regions some.scene.json --on floor").err, testing::HasSubstr("unknown option '--on'\n"));
  EXPECT_THAT(gnomon("check a.scene.json b.scene.json").err, testing::HasSubstr("unexpected argument 'b.scene.json'"));
}

}  // namespace
}  // namespace gnomon
