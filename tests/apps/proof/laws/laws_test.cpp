#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "apps/proof/laws/law.h"

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
    EXPECT_GE(outcome.premise_share(), 0.2);
    if (law_.standing == Standing::refuted) expect_refuted(outcome);
  }

  void expect_refuted(const Outcome& found) const {
    std::cout << "refuted by " << found.refuting << " of them\n";
    EXPECT_GT(found.refuting, 0u);
    const Outcome known = law_.known({});
    EXPECT_GT(known.cases, 0u);
    EXPECT_EQ(known.refuting, known.cases) << "a counterexample of the theory no longer refutes the claim";
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

std::vector<std::string> keys_without_entry() {
  std::vector<std::string> missing = all_keys();
  for (const Law& law : all_laws()) std::erase(missing, law.key);
  return missing;
}

TEST(Laws, AreListedOnceEachInTheOrderOfTheTheory) {
  ASSERT_TRUE(registered);
  std::vector<std::string> keys;
  const std::vector<std::string> expected = all_keys();
  for (const Law& law : all_laws()) {
    if (!law.key.ends_with("_any")) keys.push_back(law.key);
  }
  EXPECT_EQ(expected.size(), 88u);
  EXPECT_EQ(keys, expected);
}

TEST(Laws, HaveAnEntryForEveryStatement) {
  EXPECT_EQ(keys_without_entry(), std::vector<std::string>{});
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
