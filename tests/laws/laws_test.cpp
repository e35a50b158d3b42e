#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "apps/laws/law.h"

namespace gnomon::laws {
namespace {

/// One law in one domain.
class LawTest : public testing::Test {
 public:
  LawTest(Law law, Domain domain) : law_(std::move(law)), domain_(domain) {}

  void TestBody() override {
    Parameters parameters;
    parameters.cases = GNOMON_LAW_CASES;
    const Outcome outcome = law_.run(domain_, parameters);
    std::cout << law_.key << " " << law_.source << ": " << law_.statement << "\nseed " << parameters.seed << ", "
              << outcome.cases << " cases, premise held in " << outcome.premise_held << "\n";
    EXPECT_FALSE(outcome.counterexample) << *outcome.counterexample;
    EXPECT_GE(outcome.premise_held, parameters.cases);
  }

 private:
  Law law_;
  Domain domain_;
};

bool register_laws() {
  for (const Law& law : all_laws()) {
    for (const Domain domain : {Domain::random, Domain::near_degenerate}) {
      const std::string suite = "Laws/" + law.key;
      const char* name = domain == Domain::random ? "HoldsOnRandomPairs" : "HoldsOnNearDegeneratePairs";
      testing::RegisterTest(suite.c_str(), name, nullptr, nullptr, __FILE__, __LINE__,
                            [=]() -> testing::Test* { return new LawTest(law, domain); });
    }
  }
  return true;
}

const bool registered = register_laws();

TEST(Laws, AreListedOnceEach) {
  ASSERT_TRUE(registered);
  std::set<std::string> keys;
  for (const Law& law : all_laws()) EXPECT_TRUE(keys.insert(law.key).second) << law.key;
  for (const char* key :
       {"S1",  "S2",     "S3",     "S4",      "S5",      "S6", "S7", "S8", "S9", "S10", "S11", "S12", "S13", "S14",
        "S15", "S6_any", "S9_any", "S12_any", "S14_any", "M4", "P1", "P2", "P3", "P4",  "P5",  "P6",  "P7",  "P8",
        "P9",  "P10",    "Q1",     "Q2",      "Q3",      "Q4", "Q5", "Q6", "F3", "F4",  "F5",  "M1",  "M2",  "M3"}) {
    EXPECT_TRUE(keys.contains(key)) << key;
  }
}

TEST(Laws, ShowTheSameForTheSameSeed) {
  const std::vector<Law> all = all_laws();
  const Law law = *std::ranges::find(all, std::string("S1"), &Law::key);
  const auto cases = [&](std::uint64_t seed) {
    Parameters parameters;
    parameters.seed = seed;
    parameters.cases = 50;
    std::size_t called = 0;
    parameters.subject.shadow_volumes = [&](const Light& light, const ConvexBlocker& blocker) -> ShadowVolumes {
      if (++called == 20) throw std::runtime_error("the twentieth pair");
      return shadow_volumes(light, blocker);
    };
    return law.run(Domain::random, parameters).counterexample.value_or("");
  };
  EXPECT_EQ(cases(7), cases(7));
  EXPECT_NE(cases(7), cases(8));
}

}  // namespace
}  // namespace gnomon::laws
