#include "shading/reflection/paired_moments.h"

#include <gtest/gtest.h>

#include "tests/support/dice.h"

namespace gnomon::shading {
namespace {

/// Whole numbers, so that both levels start from the very same arcs.
struct WholeArc {
  Vector start, end;
};

template <class Number>
Vector3<Number> unit_from(const Vector& v) {
  return unit_of(Vector3<Number>{v.x, v.y, v.z});
}

template <class Number>
std::vector<Arc<Number>> arcs_of(const std::vector<WholeArc>& ends) {
  std::vector<Arc<Number>> arcs;
  for (const auto& [a, b] : ends) {
    const Vector3<Number> u = unit_from<Number>(a), v = unit_from<Number>(b), axis = cross(u, v);
    arcs.push_back({u, v, unit_of(axis), atan2(norm(axis), dot(u, v))});
  }
  return arcs;
}

std::vector<WholeArc> drawn_arcs(test_support::Dice& dice, int count) {
  const auto vector = [&] {
    return Vector{double(dice.draw(-5, 5)), double(dice.draw(-5, 5)), double(dice.draw(1, 5))};
  };
  std::vector<WholeArc> arcs;
  while (static_cast<int>(arcs.size()) < count) {
    const WholeArc arc{vector(), vector()};
    if (length(cross(arc.start, arc.end)) > 0) arcs.push_back(arc);
  }
  return arcs;
}

void expect_enclosed(const Bounded& found, const Precise& exact, int order) {
  const Bounded truth = bounded(exact);
  EXPECT_LE(std::fabs(found.value - truth.value), final_bound(found) + truth.error) << order;
  EXPECT_LT(final_bound(found), 1e-10) << order;
}

class PairedMoments : public testing::TestWithParam<int> {};

TEST_P(PairedMoments, EncloseThoseOfManyDigitsForAnyNumberOfArcs) {
  const int order = GetParam();
  const Precise::Bits protect(256);
  test_support::Dice dice(static_cast<std::uint32_t>(41 + order));
  for (int count = 0; count < 40; ++count) {
    const std::vector<WholeArc> ends = drawn_arcs(dice, count % 6);
    const Vector w{double(dice.draw(-3, 3)), double(dice.draw(-3, 3)), double(dice.draw(1, 3))};
    const auto found = arc_sums(arcs_of<Bounded>(ends), unit_from<Bounded>(w), order);
    const auto exact = arc_sums(arcs_of<Precise>(ends), unit_from<Precise>(w), order);
    ASSERT_EQ(found.sums.size(), static_cast<std::size_t>((order + 1) / 2));
    ASSERT_EQ(found.last.size(), ends.size());
    for (std::size_t k = 0; k < found.sums.size(); ++k) expect_enclosed(found.sums[k], exact.sums[k], order);
    for (std::size_t i = 0; i < ends.size(); ++i) expect_enclosed(found.last[i], exact.last[i], order);
  }
}

INSTANTIATE_TEST_SUITE_P(Orders, PairedMoments, testing::Values(0, 1, 2, 3, 10, 49, 199, 1000));

TEST(PairedMomentsDegenerate, OfNoArcsAreExactlyNothing) {
  const auto none = arc_sums(std::vector<Arc<Bounded>>{}, Vector3<Bounded>{0.0, 0.0, 1.0}, 9);
  for (const Bounded& sum : none.sums) EXPECT_TRUE(is_exact_zero(sum));
}

TEST(ShadingVector, IsScaledAsTheLibraryScales) {
  for (const double x : {1.0, -0.1, 3e-308, 5e-324, 1e308, 0.0, HUGE_VAL}) {
    for (int power = -2200; power <= 2200; power += 7)
      EXPECT_EQ(times_two_to(x, power), std::scalbn(x, power)) << power;
    if (x != 0 && x < HUGE_VAL) {
      EXPECT_EQ(exponent(Vector{0, x, 0}), std::ilogb(x));
    }
  }
  EXPECT_EQ(exponent(Vector{0, 0, 0}), 0);
}

}  // namespace
}  // namespace gnomon::shading
