#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "apps/laws/law.h"

// As in mutants_test.cpp, for the laws about many blockers.

namespace gnomon::laws {
namespace {

using Break = Visibility (*)(const Light&, Obstacles, const Point3&);

bool caught(const std::string& key, Break broken) {
  Subject subject;
  subject.visibility = broken;
  const std::vector<Law> all = all_laws();
  const Law law = *std::ranges::find(all, key, &Law::key);
  return std::ranges::all_of(std::array{Domain::random, Domain::near_degenerate}, [&](Domain domain) {
    return law.run(domain, {.cases = 1000, .subject = subject}).counterexample.has_value();
  });
}

Visibility without_last(const Light& light, Obstacles obstacles, const Point3& p) {
  obstacles.blockers.pop_back();
  return exact_visibility(light, obstacles, p);
}

Visibility umbra_for_penumbra(const Light& light, Obstacles obstacles, const Point3& p) {
  Visibility seen = exact_visibility(light, obstacles, p);
  if (seen.region == Region::penumbra) seen.region = Region::umbra;
  return seen;
}

Visibility penumbra_for_umbra(const Light& light, Obstacles obstacles, const Point3& p) {
  Visibility seen = exact_visibility(light, obstacles, p);
  if (seen.region == Region::umbra) seen.region = Region::penumbra;
  return seen;
}

TEST(LawsCatch, AForgottenBlocker) {
  EXPECT_TRUE(caught("M1", without_last));
  EXPECT_TRUE(caught("M3", without_last));
}

TEST(LawsCatch, UmbraTakenForPenumbraAndTheOtherWayRound) {
  EXPECT_TRUE(caught("M2", penumbra_for_umbra));
  EXPECT_TRUE(caught("M3", penumbra_for_umbra));
  EXPECT_TRUE(caught("M3", umbra_for_penumbra));
}

}  // namespace
}  // namespace gnomon::laws
