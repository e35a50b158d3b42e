#include <array>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/program.h"

namespace gnomon {
namespace {

constexpr std::array commands{
    Command{"shadow", "extremal planes and shadow volumes, for ParaView", shadow_command},
    Command{"check", "validates a scene and prints what was recognised", check_command},
    Command{"regions", "region and visible fraction of every light at given points", regions_command},
    Command{"grid", "the same for the points of a grid, as VTK image data", grid_command},
    Command{"irradiance", "the irradiance that every light gives to given points", irradiance_command, true},
    Command{"radiance", "what surfaces reflect to eyes, at given points", radiance_command},
    Command{"discontinuities", "surfaces where what is seen of a light changes its formula", discontinuities_command},
    Command{"receivers", "regions and discontinuity mesh on every receiver", receivers_command},
    Command{"illuminate", "meshes of receivers whose irradiance is within a tolerance", illuminate_command, true},
    Command{"view-factors", "view factors between surfaces, each with a bound", view_factors_command, true},
    Command{"place", "every place of a light that casts wanted shadows", place_command},
    Command{"sunlight", "when the sun shines on points through a day", sunlight_command},
    Command{"fit", "intensities of lights, or a material, for wanted brightness", fit_command},
    Command{"render", "makes a picture of a scene or of a result folder", render_command},
    Command{"image", "a picture of what a scene's camera sees, with error bounds", image_command},
    Command{"import", "a scene of models and their materials", import_command},
    Command{"example", "prints an installed example, or their list", example_command},
};

constexpr std::array proof_commands{
    Command{"theorems", "checks every statement of the theory, refutes the false ones",
            [](Arguments arguments) { return proof_command("theorems", arguments); }},
    Command{"report", "measures speed against error and tries hard cases, with plots",
            [](Arguments arguments) { return proof_command("report", arguments); }},
};

constexpr ProgramText program{
    "gnomon",
    "gnomon computes exact shadow volumes of lights behind blockers, and hands them to ParaView.",
    commands,
    "Commands that gnomon-proof runs, a program that is installed by itself",
    proof_commands,
    "  gnomon shadow --out shadow_of_default\n"
    "  gnomon check examples/cornell_box.scene.json\n"};

}  // namespace
}  // namespace gnomon

int main(int argc, char** argv) {
  return gnomon::run_program(gnomon::program, argc, argv);
}
