#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TheoremsCommand : public Program {};

/// The document without its seconds, which no two runs share.
json without_seconds(json document) {
  for (json& statement : document.at("statements")) statement.erase("seconds");
  return document;
}

TEST_F(TheoremsCommand, TellsKeyStatementCasesAndStatusOfEveryStatement) {
  const Outcome run = gnomon("theorems --cases 10");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  EXPECT_THAT(run.out, AllOf(HasSubstr("key"), HasSubstr("P10"), HasSubstr("([CF91] Theorem 2)"), HasSubstr("holds"),
                             HasSubstr("refuted"), HasSubstr("Regions of the cases")));
}

TEST_F(TheoremsCommand, CountsCasesSharesAndRegionsInJson) {
  const json document = json::parse(gnomon("theorems --cases 21 --seed 5 --only S4,P7,S4 --json -").out);
  EXPECT_EQ(document["schema"], "gnomon/theorems/1");
  EXPECT_EQ(document["seed"], 5);
  ASSERT_EQ(document["statements"].size(), 2u);
  const json& statement = document["statements"][1];
  EXPECT_EQ(statement["key"], "S4");
  EXPECT_EQ(statement["source"], "[CF91] Theorem 2");
  EXPECT_EQ(statement["status"], "holds");
  EXPECT_EQ(statement["cases"], 21);
  EXPECT_EQ(statement["drawn"], 21);
  EXPECT_EQ(statement["premise_share"], 1.0);
  EXPECT_GE(statement["seconds"], 0.0);
  const json& regions = statement["regions"];
  EXPECT_EQ(regions["cases"], 21);
  EXPECT_EQ(regions["umbrae"], json::array({0, 21, 0}));
  for (const char* kind : {"points", "penumbrae", "pockets"}) {
    const auto counts = regions[kind].get<std::vector<int>>();
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0), 21) << kind;
  }
}

TEST_F(TheoremsCommand, ShowsTheSameOnAnyNumberOfThreads) {
  const std::string arguments = "theorems --cases 500 --only S1,P4,F5 --json - --threads ";
  const json one = without_seconds(json::parse(gnomon(arguments + "1").out));
  EXPECT_EQ(one, without_seconds(json::parse(gnomon(arguments + "3").out)));
  const std::string failing = "theorems --cases 900 --mutant strict_planar_umbra --only P1,P9 --json - --threads ";
  const json failure = without_seconds(json::parse(gnomon(failing + "1").out));
  EXPECT_EQ(failure, without_seconds(json::parse(gnomon(failing + "3").out)));
  EXPECT_EQ(failure["statements"][0]["status"], "counterexample");
}

TEST_F(TheoremsCommand, DrawsOtherCasesForAnotherSeed) {
  const std::string arguments = "theorems --cases 100 --only S4 --json - --seed ";
  EXPECT_NE(json::parse(gnomon(arguments + "1").out)["statements"][0]["regions"],
            json::parse(gnomon(arguments + "2").out)["statements"][0]["regions"]);
}

TEST_F(TheoremsCommand, WritesTheCounterexamplesOfRefutedClaimsAsScenesThatSayTheSame) {
  const Outcome run = shell("PATH=/nowhere \"$GNOMON\" theorems --cases 10 --only F1,F4 --out found");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("warning: no pictures: no display"));
  EXPECT_THAT(run.out, HasSubstr("F1, [CF91] 4.2.3: refuted"));
  EXPECT_THAT(names_in("found"), ElementsAre("F1.csv", "F1.scene.json", "F4.csv", "F4.scene.json"));
  EXPECT_THAT(gnomon("regions found/F1.scene.json --at found/F1.csv").out, HasSubstr("light,umbra,0,0"));
  EXPECT_THAT(gnomon("regions found/F4.scene.json --at found/F4.csv").out, HasSubstr("light,penumbra"));
}

TEST_F(TheoremsCommand, ShrinksALawThatFailsWritesItAndSaysHowToSeeItAgain) {
  const Outcome run = gnomon("theorems --cases 1000 --seed 3 --only P8 --mutant invert_penumbra_side");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, AllOf(HasSubstr("COUNTEREXAMPLE FOUND"), HasSubstr("written    ./P8.scene.json")));
  EXPECT_THAT(run.err,
              AllOf(HasSubstr("P8, own: counterexample found"), HasSubstr("the penumbra differs"),
                    HasSubstr("again: gnomon theorems --only P8 --seed 3 --cases 200 --mutant invert_penumbra_side")));
  EXPECT_EQ(gnomon("check P8.scene.json").code, 0);
  const Outcome again = gnomon("theorems --only P8 --seed 3 --cases 200 --mutant invert_penumbra_side");
  EXPECT_EQ(again.err, run.err);
}

TEST_F(TheoremsCommand, FailsWhereAFalseClaimIsNoLongerRefuted) {
  const Outcome run = gnomon("theorems --cases 10 --only F7 --mutant skip_blocker --json -");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(json::parse(run.out)["statements"][0]["status"], testing::AnyOf("counterexample", "not_refuted"));
}

TEST_F(TheoremsCommand, PrintsWhichStatementCatchesWhichMistake) {
  const Outcome run = gnomon("theorems --mutants --only P4,P7,Q1,S10 --json mutants.json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("drop_umbra_side"), HasSubstr("skip_segment"), HasSubstr("Q1 ")));
  const json document = read_json("mutants.json");
  EXPECT_EQ(document["schema"], "gnomon/mutants/1");
  const auto& mutants = document["mutants"];
  const auto sides = std::ranges::find_if(mutants, [](const json& m) { return m["name"] == "drop_umbra_side"; });
  ASSERT_NE(sides, mutants.end());
  EXPECT_LE((*sides)["laws"]["P4"], 1000);
  EXPECT_FALSE((*sides)["laws"].contains("S10")) << "S10 does not ask for regions of the plane";
}

TEST_F(TheoremsCommand, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(gnomon("theorems --only S99").code, 2);
  EXPECT_THAT(gnomon("theorems --only S41").err, HasSubstr("there is no statement 'S41'; the nearest is 'S1'"));
  EXPECT_THAT(gnomon("theorems --mutant skip_blockers").err, HasSubstr("the nearest is 'skip_blocker'"));
  EXPECT_EQ(gnomon("theorems --cases 0").code, 2);
  EXPECT_EQ(gnomon("theorems --mutants --out found").code, 2);
}

TEST_F(TheoremsCommand, KeepsQuietButForFailures) {
  const Outcome run = gnomon("theorems --cases 10 --only P1,F3 --quiet");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out + run.err, IsEmpty());
}

}  // namespace
}  // namespace gnomon
