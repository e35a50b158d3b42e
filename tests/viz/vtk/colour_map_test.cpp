#include "viz/vtk/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gnomon::viz {
namespace {

/// Lightness of CIE 1976, from 0 to 100.
double lightness(const Color& color) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const double y = 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ColourMap, GrowsLighterInNearlyEvenSteps) {
  const double step = (lightness(colour_of_share(1)) - lightness(colour_of_share(0))) / 64;
  ASSERT_GT(step, 1.2);
  for (int k = 0; k < 64; ++k) {
    const double found = lightness(colour_of_share((k + 1) / 64.0)) - lightness(colour_of_share(k / 64.0));
    EXPECT_GT(found, 0.75 * step) << k;
    EXPECT_LT(found, 1.25 * step) << k;
  }
}

TEST(ColourMap, HoldsColoursThatCanBeShown) {
  for (int k = 0; k <= 256; ++k) {
    for (const double channel : colour_of_share(k / 256.0)) {
      EXPECT_GT(channel, 0) << k;
      EXPECT_LT(channel, 1) << k;
    }
  }
  EXPECT_EQ(colour_of_share(-1), colour_of_share(0));
  EXPECT_EQ(colour_of_share(INFINITY), colour_of_share(1));
}

TEST(RoundScale, HoldsTheValueInFourToEightRoundSteps) {
  for (const double value : {1e-300, 3e-7, 0.7, 0.99, 1.0, 1.01, 1.9, 2.1, 4.9, 5.01, 9.99, 10.0, 123.0, 1e300}) {
    const RoundScale scale = round_scale(value);
    EXPECT_GE(scale.top(), value * (1 - 1e-14));
    EXPECT_LE(scale.top(), value * 1.34) << value;
    EXPECT_GE(scale.steps, 4) << value;
    EXPECT_LE(scale.steps, 8) << value;
    const double digits = scale.step / std::pow(10, std::floor(std::log10(scale.step * 1.001)));
    EXPECT_TRUE(std::fabs(digits - 1) < 1e-9 || std::fabs(digits - 2) < 1e-9 || std::fabs(digits - 5) < 1e-9) << value;
  }
}

TEST(RoundScale, IsThereForNothingAndForTheSmallestNumbers) {
  EXPECT_EQ(round_scale(0).top(), 1);
  EXPECT_GE(round_scale(5e-324).top(), 5e-324);
}

}  // namespace
}  // namespace gnomon::viz
