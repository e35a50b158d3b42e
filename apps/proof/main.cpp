#include <array>

#include "apps/gnomon/program.h"
#include "apps/proof/proof_commands.h"

namespace gnomon {
namespace {

constexpr std::array commands{
    Command{"theorems", "checks every statement of the theory, refutes the false ones", theorems_command},
    Command{"report", "measures speed against error and tries hard cases, with plots", report_command},
};

constexpr ProgramText program{
    "gnomon-proof",
    "gnomon-proof checks the theory that gnomon rests on, and measures gnomon beside other programs.",
    commands,
    {},
    {},
    "  gnomon-proof theorems --cases 40\n"
    "  gnomon-proof report --out report_quick --quick\n"};

}  // namespace
}  // namespace gnomon

int main(int argc, char** argv) {
  return gnomon::run_program(gnomon::program, argc, argv);
}
