#pragma once

/// @file
/// Pictures of results, and pages that turn with the mouse.
///
///     #include <gnomon/picture.h>
///     int main() {
///       using namespace gnomon;
///       const Scene scene = parse_scene(default_scene_text(), "default", ".");
///       render_scene({&scene, default_clip_box(scene).value(), {}}, "scene.html");  // no display is needed for a page
///       return picture_format("scene.html") == PictureFormat::html ? 0 : 1;
///     }

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gnomon/errors.h"
#include "gnomon/point.h"
#include "gnomon/result.h"

namespace gnomon {

/// There is no X display to render on, and none can be started. what() tells the user what to do.
class NoDisplayError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a picture is written as.
enum class PictureFormat {
  png,   ///< pixels; the only one that needs a display, and starts a virtual one if there is none
  svg,   ///< a line drawing; scenes of the plane only
  gltf,  ///< every surface of the result, for other programs
  html,  ///< one page that needs nothing else; in space it turns with the mouse
};

/// The format that the file's ending asks for, or nothing.
std::optional<PictureFormat> picture_format(const std::filesystem::path& file);

/// From where a scene in space is seen; it is framed so that everything is in the picture. Where z is up, the front is
/// seen along y, the left along x; where y is up, the front is seen against z.
enum class CameraPreset { three_quarter, front, back, left, right, top, bottom };

/// The preset of that name ("three-quarter", "front", ...), or nothing.
std::optional<CameraPreset> camera_preset(std::string_view name);

/// A camera of one's own.
struct CameraPlace {
  Point3 position;
  std::optional<Point3> focus = {};  ///< by default the middle of what is seen
  std::optional<Point3> up = {};     ///< by default the axis that is up
};

/// Something that may be left out of a picture.
enum class Shown { yes, no };

/// What of a result is drawn; by default the first light that has results and what belongs to it. A page lets its
/// reader choose among all lights.
struct PictureSelection {
  std::string light = {};          ///< by name; empty for the default
  std::string receiver = {};       ///< by name; empty for all
  Shown part_volumes = Shown::no;  ///< volumes of parts of blockers, which hide each other and whose umbrae are not
                                   ///< the umbra of the whole
};

struct PictureOptions {
  int width = 1280;                                                              ///< pixels
  int height = 960;                                                              ///< pixels
  std::variant<CameraPreset, CameraPlace> camera = CameraPreset::three_quarter;  ///< for scenes in space
  Shown legend = Shown::yes;
  Shown labels = Shown::yes;  ///< names of elements, as long as there are few
  PictureSelection selection = {};
  std::optional<UpAxis> up = {};  ///< by default as the scene says
};

/// Draws a light, blockers, receivers and volumes, umbra inside penumbra, with names and a legend, and writes a file of
/// the format that its ending says.
///
/// Receivers have the colours of the exact regions that the result holds, those of all blockers together, and the
/// colour of none where it holds none. Surfaces and lines of discontinuities are shown by their order. A receiver that
/// has the whole scene on one side ends the volumes; a picture is no proof of that, for it is done in doubles. Walls
/// that hide the scene from the camera are drawn as outlines. A light without a place is an arrow in a corner.
///
/// A scene of the plane becomes a drawing: the clip box with its regions filled, the extremal lines, light and blocker.
///
/// Requires: result.scene is not null; width and height at least 64; the ending of a format; for SVG a scene of the
///           plane; a camera that is not at its focus; names that there are.
/// Throws:   NoDisplayError; std::runtime_error naming the file that could not be written, or what is to be installed;
///           PreconditionError.
/// While a PNG is drawn without a display, the environment's DISPLAY is another one.
void render_scene(const ShadowResult& result, const std::filesystem::path& file, const PictureOptions& options = {});

/// Draws the same picture of a folder that a command has written as vtm or vtpc.
///
/// Throws: as render_scene; ResultError naming the file that cannot be read, or is of another run than the manifest.
void render_result(const std::filesystem::path& directory, const std::filesystem::path& file,
                   const PictureOptions& options = {});

/// The dimension of the scene of such a folder, 2 or 3. Throws: ResultError naming the file.
int result_dimension(const std::filesystem::path& directory);

/// Names that may be asked for.
struct ResultNames {
  std::vector<std::string> lights;  ///< those that have results, or all if none has
  std::vector<std::string> receivers;
};

/// The names in such a folder. Throws: std::runtime_error naming the file.
ResultNames result_names(const std::filesystem::path& directory);

}  // namespace gnomon
