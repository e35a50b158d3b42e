#include "shading/reflection/lobe_table.h"

#include <gtest/gtest.h>

#include "tests/shading/reflection/definition_oracle.h"
#include "tests/shading/reflection/drawn_views.h"

namespace gnomon::shading {
namespace {

using namespace test_support;

/// The integral of cos^n to an angle with this sine, in 40 digits, by the recurrence.
Long cosine_power(double sine, int n) {
  const Long s = sine, c = sqrt(Long(1 - s * s));
  Long value = n % 2 == 0 ? Long(asin(s)) : s;
  for (int k = 2 + n % 2; k <= n; k += 2) value = (s * pow(c, k - 1) + (k - 1) * value) / k;
  return value;
}

TEST(LobeTable, IsWithinItsBoundOfAFewRoundings) {
  Dice dice(81);
  for (const int n : {100, 101, 201, 1000, 10001}) {
    const LobeTable table(n);
    const double whole = static_cast<double>(cosine_power(1, n)), reach = 10 / std::sqrt(n);
    for (int round = 0; round < 40; ++round) {
      const double s = round == 0 ? 0 : between(dice, -1, 1) * std::fmin(reach, 1);
      const Bounded value = table.at(s);
      ASSERT_LE(abs(cosine_power(s, n) - value.value), value.error) << n << ' ' << s;
      ASSERT_LE(value.error, 2e-14 * whole) << n << ' ' << s;
    }
  }
}

TEST(LobeTable, AgreesWithTheRecurrenceForArcsInSpace) {
  Dice dice(82);
  for (int round = 0; round < 300; ++round) {
    const Vector3<Bounded> a = unit_of(Vector3<Bounded>{between(dice, -1, 1), between(dice, -1, 1), 0.5});
    const Vector3<Bounded> b = unit_of(Vector3<Bounded>{between(dice, -1, 1), between(dice, -1, 1), 0.7});
    const Vector3<Bounded> axis = unit_of(cross(a, b));
    const Arc<Bounded> arc{a, b, axis, atan2(dot(axis, cross(a, b)), dot(a, b))};
    const Vector3<Bounded> w = unit_of(plus(a, times(Bounded(between(dice, 0, 1)), b)));
    constexpr std::array exponents = {100, 101, 256, 599};
    const int n = dice.one_of(exponents);
    const Bounded quick = quick_moment(arc_axis(arc, w), n), slow = arc_moment(arc_axis(arc, w), n);
    ASSERT_LE(std::fabs(quick.value - slow.value), 1.01 * (quick.error + slow.error)) << n;
    ASSERT_LE(quick.error, 1e-11);
  }
}

}  // namespace
}  // namespace gnomon::shading
