#include "geometry/numbers/printed_bound.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "geometry/numbers/kernel.h"

namespace gnomon {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// A decimal as a rational number, digit by digit.
Rational decimal(const std::string& text) {
  const std::size_t e = text.find('e');
  std::string digits = text.substr(0, e);
  int exponent = std::stoi(text.substr(e + 1));
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  Rational number{digits};
  for (; exponent > 0; --exponent) number *= 10;
  for (; exponent < 0; ++exponent) number /= 10;
  return number;
}

Rational printed(double value) {
  char text[64];
  return decimal({text, std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr});
}

Rational distance(const Rational& a, const Rational& b) {
  return a < b ? Rational(b - a) : Rational(a - b);
}

/// Whether the printed bound covers every number within `bound` of the value: the farthest ones are its ends.
void expect_covers(double value, double bound) {
  const Rational claimed = printed(printed_error_bound(value, bound));
  for (const int side : {-1, 1}) {
    const Rational end = Rational(value) + side * Rational(bound);
    EXPECT_LE(distance(printed(value), end), claimed) << value << " +- " << bound;
  }
}

TEST(PrintedErrorBound, CoversWhatADecimalIsOffItsDouble) {
  const Rational exact = Rational(31) / 45;
  const double nearest = 31.0 / 45;
  const Rational off = distance(exact, Rational(nearest));
  EXPECT_GT(distance(printed(nearest), exact), off) << "the case must be one where the decimal is farther off";
  const double bound = 5e-18;
  ASSERT_LE(off, Rational(bound));
  EXPECT_GE(printed(printed_error_bound(nearest, bound)), distance(printed(nearest), exact));
}

TEST(PrintedErrorBound, IsZeroWhereTheDecimalIsTheDouble) {
  for (const double value : {0.0, 1.0, 0.5, 0.75, 0.1875, 9.5367431640625e-07, 1e22, 123456.0, -2.5, 1e15, 0x1p40}) {
    EXPECT_EQ(printed(value), Rational(value)) << value;
    EXPECT_EQ(printed_error_bound(value, 0), 0) << value;
  }
}

TEST(PrintedErrorBound, IsZeroNowhereElse) {
  for (const double value : {0.1, 1.0 / 3, 1e23, 5e-324, 1.7976931348623157e308, 0x1p-60, 0x1p70}) {
    ASSERT_NE(printed(value), Rational(value)) << value;
    EXPECT_GT(printed_error_bound(value, 0), 0) << value;
  }
}

TEST(PrintedErrorBound, StaysInfinite) {
  EXPECT_EQ(printed_error_bound(no_limit, no_limit), no_limit);
  EXPECT_EQ(printed_error_bound(0.3, no_limit), no_limit);
}

TEST(PrintedErrorBound, HoldsForDoublesAndBoundsOfEverySize) {
  std::mt19937_64 random(20);
  const auto any_double = [&](int least, int most) {
    const int exponent = least + static_cast<int>(random() % static_cast<unsigned>(most - least));
    return std::ldexp(1 + static_cast<double>(random() % (1ULL << 52U)) * 0x1p-52, exponent);
  };
  for (int i = 0; i < 20000; ++i) {
    const double value = i % 4 == 0 ? static_cast<double>(random() % 1000) / 8 : any_double(-60, 20);
    expect_covers(value, i % 3 == 0 ? 0 : any_double(-110, -20));
  }
  for (int i = 0; i < 200; ++i) expect_covers(any_double(-1074, 1000), any_double(-1074, 1000));
}

TEST(PrintedErrorBound, IsHardlyLargerThanItHasToBe) {
  EXPECT_LE(printed_error_bound(0.3, 1e-10), 1e-10 + 0x1p-54 + 0x1p-80);
  EXPECT_LE(printed_error_bound(0.3, 0), 0x1p-54);
}

}  // namespace
}  // namespace gnomon
