#include "shading/arc_factor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gnomon {
namespace {

TEST(ArcFactorAgreement, MatchesTheArcSineInLongDoubles) {
  for (int k = 1; k <= 100000; ++k) {
    const double x = k / 400000.0;
    const long double root = std::sqrt(static_cast<long double>(x));
    const long double expected = std::asin(root) / (root * std::sqrt(1 - static_cast<long double>(x)));
    ASSERT_LE(std::fabs(arc_factor(x) - expected), arc_factor_error * expected) << x;
  }
  EXPECT_EQ(arc_factor(0.0), 1);
}

}  // namespace
}  // namespace gnomon
