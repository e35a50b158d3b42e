#include "apps/proof/laws/mutants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <stdexcept>

#include "apps/proof/laws/law.h"

// The laws are worth nothing unless they can fail: every mutant has one mistake, and names laws that see it.

namespace gnomon::laws {
namespace {

/// The law, which has to be there.
Law law_called(const std::string& key) {
  const std::vector<Law> all = all_laws();
  const auto found = std::ranges::find(all, key, &Law::key);
  if (found == all.end()) throw std::runtime_error("there is no law " + key);
  return *found;
}

Outcome outcome_of(const std::string& key, Domain domain, const Subject& subject) {
  Parameters parameters;
  parameters.subject = subject;
  return law_called(key).run(domain, parameters);
}

class MutantTest : public testing::Test {
 public:
  explicit MutantTest(Mutant mutant) : mutant_(std::move(mutant)) {}

  void TestBody() override {
    std::cout << mutant_.name << ": " << mutant_.does << "\n";
    EXPECT_FALSE(mutant_.caught_by.empty());
    for (const std::string& key : mutant_.caught_by) {
      for (const Domain domain : {Domain::random, Domain::near_degenerate}) {
        const Outcome outcome = outcome_of(key, domain, mutant_.subject);
        EXPECT_TRUE(outcome.counterexample) << key << " holds on " << name(domain) << " cases";
        std::cout << "  " << key << " catches it at " << name(domain) << " case " << outcome.cases << "\n";
      }
    }
  }

 private:
  Mutant mutant_;
};

bool register_mutants() {
  for (const Mutant& mutant : all_mutants()) {
    testing::RegisterTest("Mutants", ("IsCaught/" + mutant.name).c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [=]() -> testing::Test* { return new MutantTest(mutant); });
  }
  return true;
}

const bool mutants_registered = register_mutants();

TEST(Mutants, AreNamedOnceEach) {
  ASSERT_TRUE(mutants_registered);
  std::set<std::string> names;
  for (const Mutant& mutant : all_mutants()) EXPECT_TRUE(names.insert(mutant.name).second) << mutant.name;
}

TEST(Mutants, OfEveryKindExist) {
  std::set<std::string> kinds;
  for (const Mutant& mutant : all_mutants()) kinds.insert(mutant.name.substr(0, mutant.name.find('_')));
  for (const char* kind : {"swap", "neighbour", "drop", "invert", "skip", "strict"}) {
    EXPECT_TRUE(kinds.contains(kind)) << kind;
  }
}

TEST(Mutants, BreakThePartTheySay) {
  for (const Mutant& mutant : all_mutants()) {
    bool asked = false;
    Parameters parameters;
    parameters.cases = 1;
    parameters.subject = with_part_watched(mutant.part, [&] { asked = true; });
    law_called(mutant.caught_by.front()).run(Domain::random, parameters);
    EXPECT_TRUE(asked) << mutant.name;
  }
}

TEST(LawsCatch, AnException) {
  Subject subject;
  subject.planar_regions = [](const planar::Pair&) -> planar::ShadowRegions { throw std::runtime_error("broken"); };
  for (const char* key : {"P2", "P3", "P4", "P5", "P6", "P7", "P8", "P9", "P10"}) {
    EXPECT_TRUE(outcome_of(key, Domain::random, subject).counterexample) << key;
  }
}

TEST(LawsCatch, AClaimThatIsNoLongerRefuted) {
  Subject subject;
  subject.visibility = [](const Light&, const Obstacles&, const Point3&) { return Visibility{}; };
  const Outcome known = law_called("F7").known(subject);
  EXPECT_LT(known.refuting, known.cases);
}

}  // namespace
}  // namespace gnomon::laws
