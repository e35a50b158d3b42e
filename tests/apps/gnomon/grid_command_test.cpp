#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class GridCommand : public Program {
 protected:
  GridCommand() { write("table.scene.json", table_scene); }
};

TEST_F(GridCommand, WritesImageDataWithTheShapeAskedFor) {
  const Outcome run = gnomon("grid table.scene.json --shape 5,4,3 --box -6,-6,-1,6,6,3 --out grid.vti");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("60 points"));
  EXPECT_THAT(read("grid.vti").substr(0, 4000),
              testing::AllOf(HasSubstr("WholeExtent=\"0 4 0 3 0 2\""), HasSubstr("Name=\"region\""),
                             HasSubstr("Name=\"visible_fraction\""), HasSubstr("Name=\"error_bound\"")));
  EXPECT_THAT(gnomon("grid table.scene.json --shape 2,2,2 --out grid.vti --quiet").out, IsEmpty());
}

TEST_F(GridCommand, WritesTheSameWithAnyNumberOfThreads) {
  gnomon("grid table.scene.json --shape 9,9,9 --out one.vti --threads 1");
  gnomon("grid table.scene.json --shape 9,9,9 --out three.vti --threads 3");
  EXPECT_EQ(read("one.vti"), read("three.vti"));
}

TEST_F(GridCommand, RefusesShapesThatAreNone) {
  for (const std::string shape : {"1,2", "0,1,1", "1,1,x", "1,1,1,1", "-1,1,1", "100000,100000,1"}) {
    const Outcome run = gnomon("grid table.scene.json --shape " + shape + " --out grid.vti");
    EXPECT_EQ(run.code, 2) << shape;
    EXPECT_THAT(run.err, HasSubstr(shape));
  }
}

TEST_F(Program, RefusesABoxWhoseDiagonalOverflows) {
  write("overflow.scene.json", table_scene);
  const Outcome run =
      gnomon("grid overflow.scene.json --shape 3,3,3 --box=-1e308,-1e308,-1e308,1e308,1e308,1e308 --out grid.vti");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, testing::HasSubstr("a diagonal that is a double"));
}

}  // namespace
}  // namespace gnomon
