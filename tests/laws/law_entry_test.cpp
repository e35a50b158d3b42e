#include "apps/laws/law_entry.h"

#include <gtest/gtest.h>

#include "apps/laws/draw.h"

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

TEST(LawEntry, TakesAnExceptionForACounterexample) {
  const Outcome outcome = law({"T3", "here", "Answers."}, numbers, check_throws).run(Domain::random, {});
  ASSERT_TRUE(outcome.counterexample);
  EXPECT_EQ(*outcome.counterexample, "exception: no answer\nnumber 0");
}

}  // namespace
}  // namespace gnomon::laws
