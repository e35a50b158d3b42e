#include "apps/gnomon/point_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "gnomon/scene.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Every row as one line: the number of the line, then the coordinates or the problem.
std::vector<std::string> rows(const std::string& text, std::size_t dimension = 3) {
  std::istringstream stream(text);
  PointTable table(stream, "points.csv", dimension == 2 ? TableColumns::planar_points : TableColumns::points);
  std::vector<std::string> result;
  while (const auto row = table.next()) {
    std::ostringstream line;
    if (const auto* malformed = std::get_if<MalformedRow>(&*row)) {
      line << malformed->line << " ! " << malformed->problem;
    } else {
      const auto& [number, written, p, normal, eye] = std::get<PointRow>(*row);
      line << number << " : " << p[0] << ' ' << p[1] << ' ' << p[2] << " [" << written << ']';
    }
    result.push_back(line.str());
  }
  return result;
}

std::string refusal(const std::string& text, std::size_t dimension = 3) {
  try {
    rows(text, dimension);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PointTable, ReadsPointsAndKeepsWhatWasWritten) {
  EXPECT_THAT(rows("x,y,z\n1,2,3\n -0.5,+2e1\t,.25\n"),
              ElementsAre("2 : 1 2 3 [1,2,3]", "3 : -0.5 20 0.25 [ -0.5,+2e1\t,.25]"));
}

TEST(PointTable, AcceptsEitherLineEndAByteOrderMarkEmptyLinesAndAMissingLastOne) {
  EXPECT_THAT(rows("\xef\xbb\xbfx, y, z\r\n1,2,3\r\n\r\n  \n4,5,6"),
              ElementsAre("2 : 1 2 3 [1,2,3]", "5 : 4 5 6 [4,5,6]"));
}

TEST(PointTable, PassesFurtherColumnsThrough) {
  EXPECT_THAT(rows("x,y,z,name\n1,2,3,\"a, b\"\n1,2,3\n"),
              ElementsAre("2 : 1 2 3 [1,2,3,\"a, b\"]", "3 ! found 3 fields, expected 4"));
}

TEST(PointTable, HasTwoCoordinatesInThePlane) {
  EXPECT_THAT(rows("x,y\n1,2\n", 2), ElementsAre("2 : 1 2 0 [1,2]"));
  EXPECT_THAT(refusal("x,y,z\n", 2), HasSubstr("expected the header \"x,y\""));
}

TEST(PointTable, ReportsMalformedRowsAndGoesOn) {
  EXPECT_THAT(
      rows("x,y,z\n1,2\n1,2,3,4\none,2,3\n1,,3\n1,2,nan\n1,2,inf\n1,2,1e999\n1,2,3 4\n1,2,+-3\n7,8,9\n"),
      ElementsAre("2 ! found 2 fields, expected 3", "3 ! found 4 fields, expected 3",
                  "4 ! x: found \"one\", expected a finite number", "5 ! y: found \"\", expected a finite number",
                  "6 ! z: found \"nan\", expected a finite number", "7 ! z: found \"inf\", expected a finite number",
                  "8 ! z: found \"1e999\", expected a finite number", "9 ! z: found \"3 4\", expected a finite number",
                  "10 ! z: found \"+-3\", expected a finite number", "11 : 7 8 9 [7,8,9]"));
}

TEST(PointTable, ShowsBytesThatAreNoLettersAndCutsLongText) {
  EXPECT_THAT(rows(std::string("x,y,z\n1,2,\0\xff\n", 13) + "1,2," + std::string(100, 'a') + "\n"),
              ElementsAre("2 ! z: found \"\\x00\\xff\", expected a finite number",
                          "3 ! z: found \"" + std::string(40, 'a') + "...\", expected a finite number"));
}

TEST(PointTable, RefusesALineBeyondAllMeasureWithoutKeepingIt) {
  EXPECT_THAT(rows("x,y,z\n" + std::string(1 << 20, '1') + ",2,3\n4,5,6\n"),
              ElementsAre("2 ! found more than 65536 bytes, expected a point", "3 : 4 5 6 [4,5,6]"));
}

TEST(PointTable, NumbersTooSmallAreTheNearestDouble) {
  EXPECT_THAT(rows("x,y,z\n1e-999,-1e-999,5e-324\n"), ElementsAre(HasSubstr("2 : 0 -0 4.94066e-324")));
}

TEST(PointTable, FindsTheSeparatorInTheHeader) {
  EXPECT_THAT(rows("x;y;z\n1;2;3\n"), ElementsAre("2 : 1 2 3 [1,2,3]"));
  EXPECT_THAT(rows("x\ty\tz\tname\n1\t2\t3\t\n"), ElementsAre("2 : 1 2 3 [1,2,3,]"));
  EXPECT_THAT(rows("x y  z\n 1 2\t3 \n"), ElementsAre("2 : 1 2 3 [1,2,3]"));
  EXPECT_THAT(rows("sep=;\nx;y;z\n1;2;3\n"), ElementsAre("3 : 1 2 3 [1,2,3]"));
}

TEST(PointTable, GivesBackFieldsThatHoldCommasInQuotes) {
  EXPECT_THAT(rows("x;y;z;name\n1;2;3;a, b\n1;2;3;\"a; b\"\n"),
              ElementsAre("2 : 1 2 3 [1,2,3,\"a, b\"]", "3 : 1 2 3 [1,2,3,\"a; b\"]"));
}

TEST(PointTable, FindsColumnsByTheirNamesInAnyOrderAndCaseQuotedOrNot) {
  EXPECT_THAT(rows("id,Z,\"Y\",X\n7,3,\"2\",1\n"), ElementsAre("2 : 1 2 3 [7,3,\"2\",1]"));
}

TEST(PointTable, WithoutHeaderHoldsThreeOrSixNumbersInOrder) {
  EXPECT_THAT(rows("1,2,3\n4,5,6\n"), ElementsAre("1 : 1 2 3 [1,2,3]", "2 : 4 5 6 [4,5,6]"));
  EXPECT_THAT(rows("1 2 3 0 0 1\n"), ElementsAre("1 : 1 2 3 [1,2,3,0,0,1]"));
  EXPECT_THAT(rows("1 2\n", 2), ElementsAre("1 : 1 2 0 [1,2]"));
  EXPECT_THAT(refusal("1,2,3,4\n"), AllOf(HasSubstr("points.csv:1"), HasSubstr("three or six numbers")));
  EXPECT_THAT(refusal("1,2,3\n", 2), HasSubstr("two numbers"));
}

TEST(PointTable, TakesLinesThatBeginWithAHashForCommentsUnlessTheyNameTheColumns) {
  EXPECT_THAT(rows("# sensors\nx,y,z\n# first\n1,2,3\n"), ElementsAre("4 : 1 2 3 [1,2,3]"));
  EXPECT_THAT(rows("# z y x\n3 2 1\n"), ElementsAre("2 : 1 2 3 [3,2,1]"));
}

TEST(PointTable, EndsLinesAtReturnsToo) {
  EXPECT_THAT(rows("x,y,z\r1,2,3\r\r4,5,6"), ElementsAre("2 : 1 2 3 [1,2,3]", "4 : 4 5 6 [4,5,6]"));
}

TEST(PointTable, RefusesDecimalCommasByPlace) {
  EXPECT_THAT(rows("x;y;z\n1;2;0,5\n1;2;3\n"),
              ElementsAre("2 ! z: found \"0,5\", expected a decimal point, not a comma", "3 : 1 2 3 [1,2,3]"));
  EXPECT_THAT(refusal("0,5;1,5;2,5\n"), AllOf(HasSubstr("points.csv:1"), HasSubstr("decimal commas")));
}

TEST(PointTable, RefusesAnotherHeader) {
  EXPECT_THAT(refusal(""), AllOf(HasSubstr("points.csv"), HasSubstr("an empty file"), HasSubstr("\"x,y,z\"")));
  EXPECT_THAT(refusal("\n\na,b,c\n"), AllOf(HasSubstr("points.csv:3"), HasSubstr("\"a,b,c\"")));
  EXPECT_THAT(refusal("x,y\n"), HasSubstr("\"x,y\""));
  EXPECT_THAT(refusal("x,y,z,x\n"), HasSubstr("\"x,y,z,x\""));
  EXPECT_THAT(refusal(std::string(1 << 20, 'x')), HasSubstr("..."));
  EXPECT_THAT(refusal(std::string("\xff\xfex\0,\0", 6)), HasSubstr("UTF-16"));
}

TEST(PointTable, ReadsNormalsAndRefusesOneWithoutDirection) {
  std::istringstream stream("x,y,z,nx,ny,nz\n1,2,3,0,-1,0.5\n1,2,3,0,-0,0\n");
  PointTable table(stream, "points.csv", TableColumns::points_with_normals);
  EXPECT_EQ(std::get<PointRow>(*table.next()).normal, (std::array<double, 3>{0, -1, 0.5}));
  EXPECT_EQ(std::get<MalformedRow>(*table.next()).problem, "nx,ny,nz: found 0,0,0, expected a direction");
}

TEST(PointTable, ReadsNormalsOnDemandWhereThereAreAny) {
  const auto has_normals = [](const std::string& text) {
    std::istringstream stream(text);
    return PointTable(stream, "points.csv", TableColumns::points_perhaps_with_normals).has_normals();
  };
  EXPECT_TRUE(has_normals("nx,ny,nz,x,y,z\n"));
  EXPECT_TRUE(has_normals("1 2 3 0 0 1\n"));
  EXPECT_FALSE(has_normals("x,y,z,name\n"));
  EXPECT_FALSE(has_normals("1 2 3\n"));
  EXPECT_THROW(has_normals("x,y,z,nx,ny\n"), SceneError);
}

}  // namespace
}  // namespace gnomon
