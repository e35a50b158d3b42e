#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/gnomon/program_fixture.h"

namespace gnomon {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// gnomon and gnomon-proof, each alone or both, in a folder of the test's own.
class ProofCommand : public Program {
 protected:
  /// Runs a copy of gnomon that stands in `here`; the path is what is told.
  Outcome copied(const std::string& path, const std::string& arguments) const {
    return shell("mkdir -p here && cp \"$GNOMON\" here/gnomon && PATH='" + path + "' here/gnomon " + arguments);
  }
};

TEST_F(ProofCommand, WithoutTheProofProgramASentenceTellsHowToGetIt) {
  for (const char* command : {"theorems", "report"}) {
    const Outcome run = copied("/usr/bin:/bin", std::string(command) + " --help");
    EXPECT_EQ(run.code, 4);
    EXPECT_THAT(run.out, IsEmpty());
    EXPECT_THAT(run.err, AllOf(HasSubstr("'gnomon " + std::string(command) + "' is run by gnomon-proof"),
                               HasSubstr("package gnomon-proof"), HasSubstr("-DGNOMON_PROOF=ON")));
  }
}

TEST_F(ProofCommand, FindsTheProofProgramOnThePathAndHandsArgumentsAndExitCodeOver) {
  write("elsewhere.sh", "#!/bin/sh\nprintf '<%s>' \"$@\"\nexit 7\n");
  const Outcome made = shell("mkdir -p elsewhere && mv elsewhere.sh elsewhere/gnomon-proof && chmod +x elsewhere/*");
  ASSERT_EQ(made.code, 0) << made.err;
  const Outcome run = copied("/nowhere::" + path_of("elsewhere") + ":/usr/bin:/bin", "report 'two words' ''");
  EXPECT_EQ(run.code, 7);
  EXPECT_EQ(run.out, "<report><two words><>");
}

TEST_F(ProofCommand, FindsTheProofProgramBesideItself) {
  const Outcome run = gnomon("theorems --help");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, HasSubstr("gnomon theorems"));
}

TEST_F(ProofCommand, TheProofProgramStandsByItself) {
  const Outcome version = shell("\"$GNOMON\"-proof --version");
  EXPECT_EQ(version.out, "gnomon-proof " GNOMON_VERSION "\n");
  const Outcome help = shell("\"$GNOMON\"-proof --help");
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("Usage: gnomon-proof COMMAND"), HasSubstr("theorems"), HasSubstr("report")));
  const Outcome wrong = shell("\"$GNOMON\"-proof theorem");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, StartsWith("gnomon: there is no command 'theorem'; the nearest is 'theorems'"));
}

}  // namespace
}  // namespace gnomon
