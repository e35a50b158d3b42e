#include "apps/proof/laws/law_entry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/proof/laws/draw.h"

namespace gnomon::laws {
namespace {

struct Number {
  int value;
};

std::string description(const Number& drawn) {
  return "number " + std::to_string(drawn.value);
}

rc::Gen<Number> numbers(Domain domain) {
  return rc::gen::exec([=] { return Number{domain == Domain::random ? draw(-100, 100) : draw(5, 9)}; });
}

Verdict check_small(const Number& drawn, const Subject&) {
  if (drawn.value < 0) return premise_fails();
  return verdict(drawn.value < 40, "forty or more");
}

Verdict check_never(const Number&, const Subject&) {
  return premise_fails();
}

Verdict check_throws(const Number&, const Subject&) {
  throw std::runtime_error("no answer");
}

Law small() {
  return law({"T1", "here", "Numbers are below forty."}, numbers, check_small);
}

TEST(LawEntry, ShrinksACounterexampleToTheSmallest) {
  const Outcome outcome = small().run(Domain::random, {});
  ASSERT_TRUE(outcome.counterexample);
  EXPECT_EQ(*outcome.counterexample, "forty or more\nnumber 40");
}

TEST(LawEntry, DrawsUntilThePremiseHeldAsOftenAsAsked) {
  const Outcome outcome = small().run(Domain::near_degenerate, {.cases = 321});
  EXPECT_FALSE(outcome.counterexample);
  EXPECT_EQ(outcome.premise_held, 321u);
}

TEST(LawEntry, CountsCasesWhosePremiseFails) {
  const Outcome outcome = law({"T2", "here", "Nothing."}, numbers, check_never).run(Domain::random, {.cases = 10});
  EXPECT_EQ(outcome.cases, 200u);
  EXPECT_EQ(outcome.premise_held, 0u);
  EXPECT_EQ(outcome.premise_share(), 0);
}

/// The claim that no number is above ninety; a subject that cannot see errs.
Verdict check_claim(const Number& drawn, const Subject& subject) {
  if (!subject.visibility) return verdict(false, "errs");
  return drawn.value > 90 ? refutes("above ninety") : Verdict{};
}

Law claim(std::vector<Number> known) {
  return refuted_claim<Number>({"T4", "here", "No number is above ninety."}, std::move(known), numbers, check_claim);
}

TEST(RefutedClaim, CountsTheCasesOfWhichItIsFalseAndKeepsTheFirst) {
  const Law law = claim({});
  EXPECT_EQ(law.standing, Standing::refuted);
  const Outcome outcome = law.run(Domain::random, {.cases = 400});
  EXPECT_FALSE(outcome.counterexample);
  EXPECT_GT(outcome.refuting, 0u);
  EXPECT_LT(outcome.refuting, outcome.cases);
  EXPECT_THAT(*outcome.refutation, testing::StartsWith("above ninety\nnumber "));
}

TEST(RefutedClaim, IsTriedOnTheCasesKnownToRefuteIt) {
  const Outcome known = claim({{91}, {100}, {3}}).known({});
  EXPECT_EQ(known.cases, 3u);
  EXPECT_EQ(known.refuting, 2u);
  EXPECT_EQ(*known.refutation, "above ninety\nnumber 91");
}

TEST(RefutedClaim, FailsWhereTheSubjectErrs) {
  Parameters parameters;
  parameters.subject.visibility = nullptr;
  EXPECT_EQ(claim({}).run(Domain::near_degenerate, parameters).counterexample, "errs\nnumber 5");
  EXPECT_EQ(claim({{91}}).known(parameters.subject).counterexample, "errs\nnumber 91");
}

std::vector<int> drawn_numbers;

Verdict note(const Number& drawn, const Subject&) {
  drawn_numbers.push_back(drawn.value);
  return {};
}

std::vector<int> numbers_of(std::uint64_t seed, std::uint64_t number, std::uint32_t cases) {
  drawn_numbers.clear();
  Parameters parameters;
  parameters.seed = seed;
  parameters.stream = number;
  parameters.cases = cases;
  law({"T5", "here", "Anything."}, numbers, note).run(Domain::random, parameters);
  return drawn_numbers;
}

TEST(LawEntry, DrawsTheSameFromAStreamHoweverLong) {
  const std::vector<int> longer = numbers_of(1, 2, 30);
  EXPECT_EQ(numbers_of(1, 2, 10), std::vector<int>(longer.begin(), longer.begin() + 10));
  EXPECT_NE(numbers_of(1, 3, 30), longer);
  EXPECT_NE(numbers_of(2, 2, 30), longer);
}

TEST(LawEntry, TakesAnExceptionForACounterexample) {
  const Outcome outcome = law({"T3", "here", "Answers."}, numbers, check_throws).run(Domain::random, {});
  ASSERT_TRUE(outcome.counterexample);
  EXPECT_EQ(*outcome.counterexample, "exception: no answer\nnumber 0");
}

}  // namespace
}  // namespace gnomon::laws
