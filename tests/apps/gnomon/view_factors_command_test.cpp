#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

/// Shapiro's case: two unit squares and a square between them.
class ViewFactorsCommand : public Program {
 protected:
  ViewFactorsCommand() {
    std::ifstream file(GNOMON_EXAMPLES "/shapiro.scene.json");
    write("shapiro.scene.json", std::string(std::istreambuf_iterator<char>(file), {}));
  }

  /// The fields of a row of a CSV without quotes.
  static std::vector<std::string> fields(const std::string& row) {
    std::vector<std::string> found;
    std::istringstream stream(row);
    for (std::string field; std::getline(stream, field, ',');) found.push_back(field);
    return found;
  }
};

TEST_F(ViewFactorsCommand, TellsThePublishedFactorWithItsBound) {
  const Outcome run = gnomon("view-factors shapiro.scene.json --bound 1e-12");
  ASSERT_EQ(run.code, 0) << run.err;
  std::istringstream rows(run.out);
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "from,to,area,factor,error_bound,bound_is");
  int count = 0;
  while (std::getline(rows, row)) {
    const auto field = fields(row);
    ASSERT_EQ(field.size(), 6U) << row;
    EXPECT_NEAR(std::stod(field[3]), 0.11562060213242, 2e-14);
    EXPECT_LT(std::stod(field[4]), 1e-12);
    EXPECT_EQ(field[5], "estimate");
    ++count;
  }
  EXPECT_EQ(count, 2);
}

TEST_F(ViewFactorsCommand, TellsTheRestOfEachRowAsSky) {
  const Outcome run = gnomon("view-factors shapiro.scene.json --open --from lid");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("lid,floor,1,0.1156"), HasSubstr("lid,sky,1,0.8843")));
  EXPECT_THAT(run.out, testing::Not(HasSubstr("floor,lid")));
}

TEST_F(ViewFactorsCommand, DoubtsNoLightsSinceTheyDoNotMatter) {
  std::ifstream file(GNOMON_EXAMPLES "/shapiro.scene.json");
  json scene = json::parse(file);
  scene["lights"] = {{{"name", "lamp"}, {"shape", "point"}, {"position", {0, 0, -5}}, {"intensity", 0}}};
  scene["blockers"].push_back(scene["blockers"][0]);
  scene["blockers"].back()["name"] = "copy";
  write("dark.scene.json", scene.dump());
  EXPECT_THAT(gnomon("check dark.scene.json").out, AllOf(HasSubstr("strength is 0"), HasSubstr("its vertices are")));
  const Outcome run = gnomon("view-factors dark.scene.json");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, AllOf(HasSubstr("its vertices are those"), testing::Not(HasSubstr("light"))));
}

TEST_F(ViewFactorsCommand, WritesJsonThatFollowsItsSchemaAndSurfacesForParaView) {
  const Outcome run = gnomon("view-factors shapiro.scene.json --twice --out f.csv --json f.json --vtk surfaces");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("factors"), HasSubstr("row sums")));
  const json result = read_json("f.json");
  EXPECT_EQ(result["surfaces"].size(), 2U);
  EXPECT_EQ(result["pairs"]["divided"], 2);
  EXPECT_LT(result["reciprocity_residual"], 1e-9);
  EXPECT_THAT(read("surfaces/view_factors.vtp"), AllOf(HasSubstr("row_sum"), HasSubstr("residual")));
}

TEST_F(ViewFactorsCommand, WritesMatricesThatNumPyReads) {
  ASSERT_EQ(gnomon("view-factors shapiro.scene.json --out f.csv --npy f.npy").code, 0);
  const std::string bytes = read("f.npy");
  // As the format's description has it: magic, version, length of the head; data at a multiple of 64.
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\0", 8));
  const std::size_t head = 10 + static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ(head % 64, 0U);
  EXPECT_EQ(bytes.size(), head + 4 * 8);
  write("read.py",
        "import numpy\n"
        "f, b = numpy.load('f.npy'), numpy.load('f_bound.npy')\n"
        "assert f.shape == b.shape == (2, 2) and f.dtype == numpy.float64, f\n"
        "assert f[0, 0] == f[1, 1] == 0 and abs(f[0, 1] - 0.11562060213242) <= b[0, 1] + 1e-14, f\n");
  const Outcome run = shell("/usr/bin/python3 read.py");
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST_F(ViewFactorsCommand, TakesFacetsOfBlockersFromOutside) {
  const Outcome run = gnomon("view-factors shapiro.scene.json --faces --out f.csv --json f.json");
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = read_json("f.json");
  ASSERT_EQ(result["surfaces"].size(), 2U);
  EXPECT_EQ(result["surfaces"][0]["name"], "board/front");
  EXPECT_EQ(result["surfaces"][1]["name"], "board/back");
  EXPECT_EQ(result["factors"]["proven"], 0);
}

TEST_F(ViewFactorsCommand, ScalesToClosureIntoAFileOfItsOwn) {
  write("box.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [], "blockers": [], "receivers": [
    {"name": "floor", "shape": "polygon", "vertices": [[0,0,0], [1,0,0], [1,1,0], [0,1,0]]},
    {"name": "lid", "shape": "polygon", "vertices": [[0,0,1], [0,1,1], [1,1,1], [1,0,1]]},
    {"name": "west", "shape": "polygon", "vertices": [[0,0,0], [0,1,0], [0,1,1], [0,0,1]]},
    {"name": "east", "shape": "polygon", "vertices": [[1,0,0], [1,0,1], [1,1,1], [1,1,0]]},
    {"name": "south", "shape": "polygon", "vertices": [[0,0,0], [0,0,1], [1,0,1], [1,0,0]]},
    {"name": "north", "shape": "polygon", "vertices": [[0,1,0], [1,1,0], [1,1,1], [0,1,1]]}]})");
  const Outcome run = gnomon("view-factors box.scene.json --out f.csv --enforce e.csv --json f.json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("e.csv: scaled so that row sums are 1"));
  EXPECT_LT(read_json("f.json")["closure_residual"], 1e-13);
  EXPECT_EQ(fields(read("e.csv")).size(), fields(read("f.csv")).size());
}

TEST_F(ViewFactorsCommand, RefusesWhatItCannotUse) {
  EXPECT_EQ(gnomon("view-factors shapiro.scene.json --bound 0").code, 2);
  EXPECT_EQ(gnomon("view-factors shapiro.scene.json --bound nan").code, 2);
  EXPECT_EQ(gnomon("view-factors shapiro.scene.json --npy f.bin").code, 2);
  EXPECT_EQ(gnomon("view-factors shapiro.scene.json --open --enforce e.csv").code, 2);
  EXPECT_EQ(gnomon("view-factors shapiro.scene.json --out shapiro.scene.json").code, 2);
  EXPECT_THAT(gnomon("view-factors shapiro.scene.json --from roof").err,
              AllOf(HasSubstr("'roof'"), HasSubstr("'lid'")));
  EXPECT_EQ(gnomon("view-factors examples/figure_4_17.scene.json").code, 4);
  write("huge.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [], "blockers": [], "receivers": [
    {"name": "floor", "shape": "polygon", "vertices": [[0,0,0], [1e99,0,0], [0,1e99,0]]}]})");
  const Outcome huge = gnomon("view-factors huge.scene.json");
  EXPECT_EQ(huge.code, 4);
  EXPECT_THAT(huge.err, AllOf(HasSubstr("floor"), HasSubstr("2^200")));
  write("empty.scene.json", R"({"gnomon": 1, "dimension": 3, "lights": [], "blockers": []})");
  const Outcome empty = gnomon("view-factors empty.scene.json");
  EXPECT_EQ(empty.code, 0);
  EXPECT_THAT(empty.err, HasSubstr("there are no receivers"));
}

}  // namespace
}  // namespace gnomon
