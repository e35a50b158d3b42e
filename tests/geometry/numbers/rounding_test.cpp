#include "geometry/numbers/rounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gnomon {
namespace {

TEST(NearestDouble, ReturnsDoublesUnchanged) {
  for (const double x : {0.0, 1.0, -0.1, 1e308, std::numeric_limits<double>::denorm_min(), 0x1.8p-1060}) {
    EXPECT_EQ(nearest_double(Rational(x)), x);
  }
}

TEST(NearestDouble, BreaksTiesToEven) {
  const Rational half_ulp = Rational(0x1p-53);
  EXPECT_EQ(nearest_double(Rational(1 + half_ulp)), 1.0);
  EXPECT_EQ(nearest_double(Rational(1 + 3 * half_ulp)), 1 + 0x1p-51);
  EXPECT_EQ(nearest_double(Rational(1 + half_ulp + Rational(0x1p-200))), 1 + 0x1p-52);
}

TEST(NearestDouble, RoundsSubnormalsOnce) {
  const Rational least(std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(nearest_double(Rational(least / 2)), 0.0);
  EXPECT_EQ(nearest_double(Rational(least * 3 / 2)), 2 * std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(nearest_double(Rational(least * 2 / 3)), std::numeric_limits<double>::denorm_min());
}

TEST(NearestDouble, OverflowsToInfinity) {
  EXPECT_EQ(nearest_double(Rational(Rational(1e308) * 10)), HUGE_VAL);
  EXPECT_EQ(nearest_double(Rational(Rational(-1e308) * 10)), -HUGE_VAL);
}

TEST(ExactNumber, HoldsTheFractionAsText) {
  const ExactNumber third = exact_number(Rational(1) / 3);
  EXPECT_EQ(third.exact, "1/3");
  EXPECT_EQ(third.nearest, 1.0 / 3);
}

}  // namespace
}  // namespace gnomon
