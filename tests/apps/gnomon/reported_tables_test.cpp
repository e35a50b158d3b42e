#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Tables as spreadsheets and daylight tools write them: three points below a table that see nothing, half and all of
/// the lamp.
class ReportedTables : public Program {
 protected:
  Outcome regions(const std::string& file) const {
    return gnomon("regions " GNOMON_TEST_DATA "/reports/25-csv-dialects/main.scene.json --json - --at " +
                  std::string(GNOMON_TEST_DATA "/reports/25-csv-dialects/") + file);
  }

  std::vector<double> fractions(const Outcome& run) const {
    std::vector<double> result;
    const json document = json::parse(run.out);
    for (const json& point : document["points"]) {
      if (point.contains("lights")) result.push_back(point["lights"][0]["visible_fraction"]);
    }
    return result;
  }
};

TEST_F(ReportedTables, AreReadInEveryDialect) {
  for (const std::string file : {"blank_lines.csv", "bom.csv",       "comment.csv",   "cr_only.csv",
                                 "crlf.csv",        "id_last.csv",   "no_header.csv", "plain.csv",
                                 "other_order.csv", "plus_sign.csv", "quoted.csv",    "radiance.pts",
                                 "semicolon.csv",   "sep_line.csv",  "space.csv",     "spaces_after_comma.csv",
                                 "tab.csv",         "upper.csv",     "with_id.csv",   "trailing_comma.csv",
                                 "with_normals.csv"}) {
    SCOPED_TRACE(file);
    const Outcome run = regions(file);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(fractions(run), ElementsAre(0, 0.5, 1));
  }
}

TEST_F(ReportedTables, WithARowThatIsNoPointGiveTheOthersAndItsLine) {
  for (const std::string file : {"missing_value.csv", "nan_row.csv"}) {
    const Outcome run = regions(file);
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, AllOf(HasSubstr(file + ":3: x: found"), HasSubstr("a finite number")));
    EXPECT_THAT(fractions(run), ElementsAre(0, 0.5, 1));
  }
}

TEST_F(ReportedTables, ThatCannotBeReadAreRefusedNamingTheDialect) {
  EXPECT_THAT(regions("decimal_comma.csv").err,
              AllOf(HasSubstr("decimal_comma.csv:2: x: found \"0,0\""), HasSubstr("a decimal point")));
  EXPECT_THAT(regions("utf16.csv").err, HasSubstr("UTF-16"));
  EXPECT_THAT(regions("empty.csv").err, HasSubstr("an empty file"));
  for (const std::string file : {"decimal_comma.csv", "utf16.csv", "empty.csv"}) EXPECT_EQ(regions(file).code, 3);
  EXPECT_EQ(json::parse(regions("header_only.csv").out)["point_count"], 0);
}

TEST_F(ReportedTables, AreGivenBackWithCommasAndTheirFieldsAsWritten) {
  write("points.txt", "Z;\"Y\";X;label\n0.0;+0;0e0;under, the table\n");
  EXPECT_EQ(gnomon("regions " GNOMON_TEST_DATA "/reports/25-csv-dialects/main.scene.json --at points.txt").out,
            "Z,\"Y\",X,label,light,region,visible_fraction,error_bound\n"
            "0.0,+0,0e0,\"under, the table\",lamp,umbra,0,0\n");
}

}  // namespace
}  // namespace gnomon
