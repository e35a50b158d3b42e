#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The program as several processes, where it was built with MPI.
class ManyProcesses : public Program {
 protected:
  ManyProcesses() { write("table.scene.json", lit_table); }

  static constexpr const char* mpirun =
      "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 "
      "OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_plm=isolated "
      "mpirun --quiet -n ";

  Outcome together(int count, const std::string& arguments) const {
    return shell(mpirun + std::to_string(count) + " \"$GNOMON\" " + arguments);
  }

  /// In a folder of its own for the second process.
  Outcome apart(const std::string& arguments) const {
    return shell("export GNOMON; " + std::string(mpirun) +
                 "2 sh -c 'if [ \"$OMPI_COMM_WORLD_RANK\" = 1 ]; then mkdir -p apart; cd apart; fi; exec \"$GNOMON\" " +
                 arguments + "'");
  }

  static inline const std::string lit_table = R"({"gnomon": 1, "dimension": 3,
    "lights": [{"name": "lamp", "shape": "polygon", "vertices": [[-1,-1,4], [-1,1,4], [1,1,4], [1,-1,4]]}],
    "blockers": [{"name": "table", "shape": "polygon", "vertices": [[-1,-1,2], [1,-1,2], [1,1,2], [-1,1,2]]}],
    "receivers": [{"name": "floor", "shape": "polygon", "vertices": [[-4,-4,0], [4,-4,0], [4,4,0], [-4,4,0]]},
      {"name": "wall", "shape": "polygon", "vertices": [[-4,4,0], [4,4,0], [4,4,5], [-4,4,5]]}]})";
};

#ifdef GNOMON_MPI

TEST_F(ManyProcesses, WriteTheBytesThatOneWrites) {
  write("points.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,1\nwrong\n2,0,0,0,0,1\n1,1.5,0,0,0,1\n");
  const auto run = [&](int count, const std::string& to) {
    const std::string one = "table.scene.json --quiet ";
    const auto go = [&](const std::string& arguments) {
      return count == 0 ? gnomon(arguments) : together(count, arguments);
    };
    std::vector<int> codes;
    for (const std::string& arguments :
         {"illuminate " + one + "--relative 0.05 --out " + to + "_mesh --json " + to + "_mesh.json",
          "view-factors " + one + "--bound 1e-5 --out " + to + "_factors.csv --json " + to + "_factors.json",
          "irradiance " + one + "--at points.csv --eye 1,2,3 --out " + to + "_points.csv --json " + to + "_points.json",
          "irradiance " + one + "--on floor --shape 9,9 --out " + to + "_grid.csv --values " + to + "_grid.txt"}) {
      codes.push_back(go(arguments).code);
    }
    return codes;
  };
  const std::vector<int> alone = run(0, "one");
  EXPECT_EQ(alone, (std::vector<int>{0, 0, 3, 0}));
  for (const int count : {1, 2}) {
    const std::string to = "of" + std::to_string(count);
    EXPECT_EQ(run(count, to), alone) << count;
    for (const std::string file :
         {"_mesh.json", "_factors.csv", "_factors.json", "_points.csv", "_points.json", "_grid.csv", "_grid.txt",
          "_mesh/shadow/illumination/floor.vtp", "_mesh/shadow/illumination/wall.vtp", "_mesh/illumination.vtm"}) {
      EXPECT_EQ(read(to + file), read("one" + file)) << file;
    }
  }
}

TEST_F(ManyProcesses, PrintOnce) {
  const Outcome run = together(2, "view-factors table.scene.json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, gnomon("view-factors table.scene.json").out);
}

TEST_F(ManyProcesses, AllEndWhereOneFailsAndLeaveTheOldResult) {
  write("mesh.json", "old");
  const Outcome run = apart("illuminate table.scene.json --json mesh.json");
  EXPECT_NE(run.code, 0);
  EXPECT_THAT(run.err, AllOf(HasSubstr("process 1 of 2"), HasSubstr("table.scene.json: found no such file")));
  EXPECT_EQ(read("mesh.json"), "old");
}

TEST_F(ManyProcesses, RefuseScenesThatDiffer) {
  std::string other = lit_table;
  other.replace(other.find("4,4,5"), 5, "4,4,6");
  ASSERT_EQ(shell("mkdir apart").code, 0);
  write("apart/table.scene.json", other);
  for (const std::string command : {"illuminate table.scene.json", "view-factors table.scene.json",
                                    "irradiance table.scene.json --on floor --shape 2,2 --out grid.csv"}) {
    const Outcome run = apart(command);
    EXPECT_NE(run.code, 0) << command;
    EXPECT_THAT(run.err, HasSubstr("different scenes")) << command;
  }
  EXPECT_FALSE(exists("grid.csv"));
}

TEST_F(ManyProcesses, RunNoCommandThatCannotShareItsWork) {
  const Outcome run = together(2, "check table.scene.json");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("'check' runs in one"), HasSubstr("illuminate")));
  const Outcome piped = together(2, "irradiance table.scene.json --at -");
  EXPECT_EQ(piped.code, 2);
  EXPECT_THAT(piped.err, HasSubstr("expected a file"));
}

#else

TEST_F(ManyProcesses, AreRefusedByAProgramWithoutMpi) {
  for (const std::string name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const Outcome run = shell(name + "=2 \"$GNOMON\" illuminate table.scene.json --json mesh.json");
    EXPECT_EQ(run.code, 4);
    EXPECT_THAT(run.err, HasSubstr("GNOMON_MPI"));
    EXPECT_FALSE(exists("mesh.json"));
  }
  EXPECT_EQ(shell("OMPI_COMM_WORLD_SIZE=1 \"$GNOMON\" check table.scene.json").code, 0);
}

#endif

}  // namespace
}  // namespace gnomon
