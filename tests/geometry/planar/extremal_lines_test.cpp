#include "gnomon/flatland_pair.h"

#include <gtest/gtest.h>

#include <vector>

#include "gnomon/errors.h"

namespace gnomon::planar {
namespace {

using Points = std::vector<Point2>;
using Lines = std::array<ExtremalLine, 4>;

Lines lines_of(const Points& light, const Points& blocker) {
  return extremal_lines(Pair::from_points(light, blocker));
}

Lines lines_named(std::array<std::uint32_t, 2> separating, std::array<std::uint32_t, 2> supporting) {
  const auto line = [](Contact contact, std::uint32_t blocker_end, std::uint32_t light_end) {
    return ExtremalLine{contact, BlockerVertex{blocker_end}, LightVertex{light_end}};
  };
  return {line(Contact::separating, 0, separating[0]), line(Contact::separating, 1, separating[1]),
          line(Contact::supporting, 0, supporting[0]), line(Contact::supporting, 1, supporting[1])};
}

TEST(ExtremalLines, OfTwoParallelSegmentsCrossForSeparatingOnes) {
  EXPECT_EQ(lines_of({{-1, 2}, {1, 2}}, {{-1, 0}, {1, 0}}), lines_named({1, 0}, {0, 1}));
}

TEST(ExtremalLines, FollowTheOrderOfTheEnds) {
  EXPECT_EQ(lines_of({{1, 2}, {-1, 2}}, {{-1, 0}, {1, 0}}), lines_named({0, 1}, {1, 0}));
  EXPECT_EQ(lines_of({{-1, 2}, {1, 2}}, {{1, 0}, {-1, 0}}), lines_named({0, 1}, {1, 0}));
  EXPECT_EQ(lines_of({{-1, -2}, {1, -2}}, {{-1, 0}, {1, 0}}), lines_named({1, 0}, {0, 1}));
}

TEST(ExtremalLines, TouchOneEndOfALightWhoseLineMeetsTheBlocker) {
  EXPECT_EQ(lines_of({{0, 1}, {0, 2}}, {{-1, 0}, {1, 0}}), lines_named({0, 0}, {1, 1}));
}

TEST(ExtremalLines, FollowALightThatPointsPastTheBlocker) {
  EXPECT_EQ(lines_of({{4, 1}, {5, 2}}, {{-1, 0}, {1, 0}}), lines_named({0, 1}, {1, 0}));
}

TEST(ExtremalLinesDegenerate, APointLightIsNamedForBothContacts) {
  EXPECT_EQ(lines_of({{0, 3}}, {{-1, 0}, {1, 0}}), lines_named({0, 0}, {0, 0}));
}

TEST(ExtremalLinesDegenerate, AnEndOfTheBlockerOnTheLightsLineNamesLightEndZero) {
  EXPECT_EQ(lines_of({{1, 2}, {1, 1}}, {{-1, 0}, {1, 0}}), lines_named({1, 0}, {0, 0}));
  EXPECT_EQ(lines_of({{1, 1}, {1, 2}}, {{-1, 0}, {1, 0}}), lines_named({0, 0}, {1, 0}));
}

TEST(ExtremalLines, NeedAPairInStandardPosition) {
  EXPECT_THROW(lines_of({{0, -1}, {0, 1}}, {{-1, 0}, {1, 0}}), PreconditionError);
  EXPECT_THROW(lines_of({{3, 0}, {3, 1}}, {{-1, 0}, {1, 0}}), PreconditionError);
  EXPECT_THROW(lines_of({{3, 0}}, {{-1, 0}, {1, 0}}), PreconditionError);
}

}  // namespace
}  // namespace gnomon::planar
