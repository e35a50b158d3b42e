#include "apps/gnomon/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
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

/// Every line with its number of characters, if there is one that is too long.
std::string too_long(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; };
    if (std::count_if(line.begin(), line.end(), starts) > 80) return line;
  }
  return "";
}

TEST(Aligned, BreaksTheLastColumnBetweenWordsWhereThereIsNoRoom) {
  const std::string long_reason =
      "the light's vertices are not exactly coplanar, so the blocker has to lie apart from it";
  const std::string text =
      aligned({{"lamp", "table", "standard", "supported"}, {"lamp", "shelf", "both_cross", long_reason}}, 2);
  EXPECT_EQ(too_long(text), "");
  EXPECT_THAT(text,
              testing::StartsWith("  lamp  table  standard    supported\n  lamp  shelf  both_cross  the light's"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
}

TEST(Aligned, LeavesOutTheMiddleOfNamesThatAreTooLong) {
  const std::string name = std::string(90, 'a') + std::string(90, 'z'), umlauts = [] {
    std::string text;
    for (int i = 0; i < 100; ++i) text += "ü";
    return text;
  }();
  const std::string text = aligned({{name, "1"}, {umlauts, "2"}, {"b", "3"}}, 0);
  EXPECT_EQ(too_long(text), "");
  EXPECT_THAT(text, testing::ContainsRegex("^a+\\.\\.\\.z+  1\n"));
  EXPECT_THAT(text, testing::HasSubstr("ü...ü"));
}

TEST(Aligned, LeavesNumbersWhole) {
  const std::string number = "1.23456e+108 *";
  const std::string name(60, 'n');
  EXPECT_THAT(aligned({{name, name, number, number, number}}, 0),
              testing::HasSubstr(number + "  " + number + "  " + number));
}

TEST(InColumns, BreaksOptionsBelowTheirHelpAndJoinsParagraphs) {
  const std::string help =
      "Tells a lot, in a first line,\nand in a second.\n\nOptions:\n  --at FILE                   A text that goes on "
      "and on and "
      "on until there is no more room for it in one line\n  --b                         Short\n";
  EXPECT_EQ(in_columns(help),
            "Tells a lot, in a first line, and in a second.\n\nOptions:\n"
            "  --at FILE                   A text that goes on and on and on until there is\n"
            "                              no more room for it in one line\n"
            "  --b                         Short\n");
}

TEST(InColumns, LeavesWordsWholeAndNothingOut) {
  const std::string word(100, 'x');
  EXPECT_EQ(in_columns(word), word + '\n');
  EXPECT_EQ(in_columns("  " + word + " y"), "  " + word + "\n  y\n");
  EXPECT_EQ(in_columns(""), "");
  EXPECT_EQ(in_columns("\n\n"), "\n\n");
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
  EXPECT_EQ(rounded_text(2.0 / 3), "0.666667");
  EXPECT_EQ(rounded_text(104), "104");
  EXPECT_EQ(rounded_text(1234567.8), "1234570");
  EXPECT_EQ(rounded_text(-2.5), "-2.5");
  EXPECT_EQ(rounded_text(0), "0");
  EXPECT_EQ(rounded_text(1e300 / 3), "3.33333e+299");
  EXPECT_EQ(rounded_text(HUGE_VAL), number_text(HUGE_VAL));
}

}  // namespace
}  // namespace gnomon
