#include "apps/gnomon/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace gnomon {
namespace {

RC_GTEST_PROP(NumberTextProperty, ReadsBackAsTheSameDouble, (std::uint64_t bits)) {
  const double value = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(value));
  RC_ASSERT(std::bit_cast<std::uint64_t>(std::strtod(number_text(value).c_str(), nullptr)) == bits);
}

TEST(NumberText, WritesOrdinaryNumbersWithoutAnExponent) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(-1.5), "-1.5");
  EXPECT_EQ(number_text(100000), "100000");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1e22), "1e+22");
}

TEST(Aligned, PutsColumnsBelowEachOtherAndLeavesNoTrailingSpace) {
  EXPECT_EQ(aligned({{"a", "b"}, {"long", "c"}, {"x"}}, 2), "  a     b\n  long  c\n  x\n");
}

TEST(Aligned, CountsCharactersNotBytes) {
  EXPECT_EQ(aligned({{"é", "b"}, {"ab", "c"}}, 0), "é   b\nab  c\n");
}

TEST(ShellWord, QuotesOnlyWhatTheShellWouldSplitOrReplace) {
  EXPECT_EQ(shell_word("out/view.py"), "out/view.py");
  EXPECT_EQ(shell_word("my shadows"), "'my shadows'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word(""), "''");
}

TEST(Counted, SaysOneInTheSingular) {
  EXPECT_EQ(counted(1, "pair"), "1 pair");
  EXPECT_EQ(counted(0, "pair"), "0 pairs");
}

TEST(Text, RoundsNumbersForPeopleToSixDigits) {
  EXPECT_EQ(rounded_text(1.0 / 3), "0.333333");
  EXPECT_EQ(rounded_text(1234567.8), "1234570");
  EXPECT_EQ(rounded_text(-2.5), "-2.5");
  EXPECT_EQ(rounded_text(0), "0");
  EXPECT_EQ(rounded_text(1e300 / 3), "3.33333e+299");
  EXPECT_EQ(rounded_text(HUGE_VAL), number_text(HUGE_VAL));
}

}  // namespace
}  // namespace gnomon
