#include "gnomon/irradiance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/numbers/kernel.h"
#include "tests/support/dice.h"

namespace gnomon {
namespace {

using test_support::Dice;

const Light bulb = PointLight{{0, 0, 4}};
const Light tube = LinearLight{{0, 0, 4}, {1, 0, 4}};
const Light sun = DirectionalLight{{0, 0, -1}};

TEST(UnitConversion, KnowsTheUnitsOfSceneFilesExactly) {
  ASSERT_TRUE(length_unit_named("in"));
  EXPECT_EQ(Rational(length_unit_named("in")->top) / Rational(length_unit_named("in")->bottom), Rational(254, 10000));
  EXPECT_EQ(Rational(length_unit_named("ft")->top) / Rational(length_unit_named("ft")->bottom), Rational(3048, 10000));
  EXPECT_FALSE(length_unit_named("parsec"));
  EXPECT_FALSE(length_unit_named(""));
}

TEST(UnitConversion, ChangesPointLightsBySquareMetresLinearOnesByMetresAndOthersNotAtAll) {
  const LengthUnit mm = *length_unit_named("mm");
  EXPECT_EQ(per_square_metre({2, 0}, bulb, mm).value, 2e6);
  EXPECT_EQ(per_square_metre({2, 0}, tube, mm).value, 2e3);
  EXPECT_EQ(per_square_metre({2, 0.5}, sun, mm).value, 2);
  EXPECT_EQ(per_square_metre({2, 0.5}, sun, mm).error_bound, 0.5);
  EXPECT_EQ(per_square_metre({2, 0.5}, bulb, *length_unit_named("m")).error_bound, 0.5);
  EXPECT_EQ(per_square_metre({0, 0}, bulb, mm).error_bound, 0);
  EXPECT_EQ(per_square_metre({HUGE_VAL, 0}, bulb, mm).value, HUGE_VAL);
}

TEST(UnitConversion, HasABoundThatHoldsForValuesOfEverySize) {
  Dice dice(7);
  for (int i = 0; i < 10000; ++i) {
    const double value = std::ldexp(1 + dice.draw(0, 1 << 30) * 0x1p-30, dice.draw(-1074, 990));
    const double bound = value * std::ldexp(1, -dice.draw(1, 60));
    for (const LengthUnit& unit : length_units) {
      for (const Light& light : {bulb, tube}) {
        const Irradiance converted = per_square_metre({value, bound}, light, unit);
        Rational factor = Rational(unit.bottom) / Rational(unit.top);
        if (std::holds_alternative<PointLight>(light)) factor *= factor;
        // The exact irradiance may be anywhere within the bound.
        for (const int side : {-1, 1}) {
          const Rational exact = (Rational(value) + side * Rational(bound)) * factor;
          ASSERT_LE(abs(Rational(converted.value) - exact), Rational(converted.error_bound)) << value << unit.name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace gnomon
