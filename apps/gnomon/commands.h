#pragma once

#include <span>
#include <stdexcept>
#include <string>

namespace gnomon {

/// What the program tells the shell.
enum class ExitCode {
  done = 0,
  failure = 1,      ///< something went wrong while running
  usage = 2,        ///< the command line makes no sense
  bad_scene = 3,    ///< a scene, result or line of points is missing or wrong
  unsupported = 4,  ///< nothing of what was asked for is supported
  infeasible = 5,   ///< `place --expect feasible`, and there is no answer
};

/// The command line makes no sense; what() says why.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What was asked for makes sense, but this version cannot do it; what() names it.
class UnsupportedError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The words that follow the command's name.
using Arguments = std::span<const std::string>;

/// `gnomon shadow`: the shadow volumes of every pair of a scene, as files and as JSON.
ExitCode shadow_command(Arguments arguments);

/// `gnomon check`: what a scene file holds, what is doubtful about it, and which pairs are supported.
ExitCode check_command(Arguments arguments);

/// `gnomon regions`: region and visible fraction of every light at given points, as CSV and JSON.
ExitCode regions_command(Arguments arguments);

/// `gnomon grid`: region and visible fraction of every light at the points of a grid, as VTK image data.
ExitCode grid_command(Arguments arguments);

/// `gnomon irradiance`: what every light gives to receivers at given points, as CSV and JSON.
ExitCode irradiance_command(Arguments arguments);

/// `gnomon radiance`: what surfaces at given points reflect of every light to eyes, as CSV and JSON.
ExitCode radiance_command(Arguments arguments);

/// `gnomon discontinuities`: the surfaces in space across which the visible fraction changes its formula.
ExitCode discontinuities_command(Arguments arguments);

/// `gnomon receivers`: regions and discontinuity mesh on every receiver.
ExitCode receivers_command(Arguments arguments);

/// `gnomon view-factors`: the share of what one surface sends out that reaches another, behind all blockers.
ExitCode illuminate_command(Arguments arguments);
ExitCode view_factors_command(Arguments arguments);

/// `gnomon place`: where a light may stand so that wanted shadows come about.
ExitCode place_command(Arguments arguments);

/// `gnomon sunlight`: when the sun shines on points through a day.
ExitCode sunlight_command(Arguments arguments);

/// `gnomon fit`: intensities of lights, or a material, from wanted brightness.
ExitCode fit_command(Arguments arguments);

/// `gnomon import`: a scene of models and their materials.
ExitCode import_command(Arguments arguments);

/// `gnomon render`: a picture of a scene or of a folder written by `gnomon shadow`.
ExitCode render_command(Arguments arguments);

/// `gnomon image`: a picture of a scene as its camera sees it, every pixel with a bound of its error.
ExitCode image_command(Arguments arguments);

/// `gnomon example`: a scene that is installed with the program, or the list of them.
ExitCode example_command(Arguments arguments);

/// `gnomon theorems` and `gnomon report`: hands over to the program gnomon-proof, found beside this one or on the path.
///
/// Returns: never; the process is gnomon-proof from then on.
/// Throws:  UnsupportedError saying how to get gnomon-proof, where it is not there.
ExitCode proof_command(const std::string& command, Arguments arguments);

}  // namespace gnomon
