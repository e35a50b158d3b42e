#include <charconv>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/computed_shadows.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/element_choice.h"
#include "apps/gnomon/painted_receivers.h"
#include "apps/gnomon/scene_discontinuities.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/scene_pairs.h"
#include "apps/gnomon/shadow_summary.h"
#include "apps/gnomon/text.h"
#include "gnomon/errors.h"
#include "gnomon/picture.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

constexpr int smallest_side = 64;
constexpr int largest_side = 16384;

constexpr const char* endings = ".png, .svg (scenes of the plane), .gltf or .html";

struct RenderOptions : CommonOptions {
  std::string out;
  std::string size;
  std::string camera;
  std::string up;
  std::string receiver;
  std::string colour = "region";
  bool volumes = false;
  bool without_legend = false;
  bool without_labels = false;
};

void add_options(CommandLine& app, RenderOptions& options) {
  add_required_text(app, "SCENE|DIR", options.scene, "PATH", "Scene file, or a folder that a command has written");
  add_required_text(app, "--out", options.out, "FILE",
                    std::string("The picture; its ending says what it is: ") + endings);
  add_text(app, "--size", options.size, "WxH", "Width and height in pixels (default: 1280x960)");
  add_text(app, "--camera", options.camera, "CAMERA",
           "three-quarter (default), front, back, left, right, top or bottom; or the place x,y,z of the camera, the "
           "place it looks at (x,y,z,fx,fy,fz), and its up direction (x,y,z,fx,fy,fz,ux,uy,uz)");
  add_text(app, "--up", options.up, "AXIS", "The axis that points up, z or y (default: the scene's, or z)");
  add_text(app, "--receiver", options.receiver, "NAME", "Draw this receiver only");
  add_text(
      app, "--colour", options.colour, "WHAT",
      "Colour receivers by region (default), or by irradiance, which has a scale of its own for each light and no\n"
      "volumes before it without --volumes; of scenes in space, as .png or .html");
  app.add_flag("--volumes", options.volumes, "Also draw volumes of blockers that are several convex parts");
  app.add_flag("--no-legend", options.without_legend, "Leave the legend out");
  app.add_flag("--no-labels", options.without_labels,
               "Leave names out: in space those of lights, blockers and receivers, in the plane those of lines");
  add_pair_options(app, options);
  app.footer(
      "A picture shows one light, the first unless --light names another; on a page all can be chosen. Receivers have\n"
      "the colours of the exact regions behind all blockers together; --blocker chooses volumes alone. Volumes are\n"
      "drawn as far as a receiver that has all of the scene on one side, a floor, whatever --box says beyond it;\n"
      "a model (.gltf, in metres and with y up, as glTF wants it) has what is chosen for a picture, up to the box.\n"
      "A page (.html) needs no network: it carries three.js, which is read from Debian's package libjs-three.\n"
      "A PNG without a display starts a virtual one (Debian packages xvfb and libgl1-mesa-dri).\n\n"
      "Examples:\n"
      "  gnomon render examples/figure_4_22.scene.json --out front.png --camera front\n"
      "  gnomon render examples/cornell_box.scene.json --out cornell_box.gltf\n");
}

int side_from_text(std::string_view text, const std::string& option) {
  int side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  const bool is_number = error == std::errc{} && end == text.data() + text.size();
  if (is_number && side >= smallest_side && side <= largest_side) return side;
  throw UsageError("--size " + option + ": expected WIDTHxHEIGHT, each from " + std::to_string(smallest_side) + " to " +
                   std::to_string(largest_side));
}

void read_size(const std::string& size, PictureOptions& picture) {
  if (size.empty()) return;
  const std::size_t cross = std::min(size.find('x'), size.size());
  const std::string_view text = size;
  const std::string_view height = text.substr(std::min(cross + 1, size.size()));
  picture.width = side_from_text(text.substr(0, cross), size);
  picture.height = side_from_text(height, size);
}

/// What of a scene or folder is drawn, and how it stands.
void read_selection(const RenderOptions& options, PictureOptions& picture) {
  picture.selection = {options.light, options.receiver, options.volumes ? Shown::yes : Shown::no};
  if (options.up.empty()) return;
  if (options.up != "z" && options.up != "y") throw UsageError("--up " + options.up + ": expected z or y");
  picture.up = options.up == "y" ? UpAxis::y : UpAxis::z;
}

/// Draws; a camera that sees nothing is the command line's fault, and found when the scene is known.
void draw(const RenderOptions& options, const std::function<void()>& render) {
  try {
    render();
  } catch (const PreconditionError& error) {
    if (options.camera.empty()) throw;
    throw UsageError("--camera " + options.camera + ": " + error.what());
  }
}

[[noreturn]] void refuse_camera(const std::string& camera, const std::string& why) {
  throw UsageError("--camera " + camera + ": " + why +
                   "; expected three-quarter, front, back, left, right, top or bottom, or 3, 6 or 9 numbers");
}

CameraPlace camera_place(const std::string& camera) {
  std::vector<double> numbers;
  for (const std::string_view field : comma_separated(camera)) {
    const std::optional<double> number = finite_number(field);
    if (!number) refuse_camera(camera, "'" + std::string(field) + "' is neither a side nor a finite number");
    numbers.push_back(*number);
  }
  if (numbers.size() != 3 && numbers.size() != 6 && numbers.size() != 9) {
    refuse_camera(camera, "found " + counted(numbers.size(), "number"));
  }
  const auto point = [&](std::size_t i) { return Point3{numbers[i], numbers[i + 1], numbers[i + 2]}; };
  CameraPlace place{point(0)};
  if (numbers.size() >= 6) place.focus = point(3);
  if (numbers.size() == 9) place.up = point(6);
  return place;
}

PictureOptions picture_options(const RenderOptions& options) {
  PictureOptions picture;
  if (options.colour != "region" && options.colour != "irradiance") {
    throw UsageError("--colour: found '" + options.colour + "', expected region or irradiance");
  }
  if (!picture_format(options.out)) {
    throw UsageError("--out " + options.out + ": expected a file that ends in " + endings);
  }
  read_size(options.size, picture);
  read_selection(options, picture);
  if (options.without_legend) picture.legend = Shown::no;
  if (options.without_labels) picture.labels = Shown::no;
  if (options.camera.empty()) return picture;
  const std::optional<CameraPreset> preset = camera_preset(options.camera);
  if (preset) {
    picture.camera = *preset;
  } else {
    picture.camera = camera_place(options.camera);
  }
  return picture;
}

bool shows_irradiance(const RenderOptions& options) {
  return options.colour == "irradiance";
}

/// What cannot be coloured by irradiance.
void check_colour(const RenderOptions& options, int dimension, bool is_folder) {
  if (!shows_irradiance(options)) return;
  if (dimension == 2) {
    throw UnsupportedError(options.scene + ": irradiance in scenes of dimension 2 is not available");
  }
  if (is_folder) {
    throw UnsupportedError(
        options.scene + ": a folder of results holds no irradiance to colour receivers by; give the " + "scene file");
  }
  if (picture_format(options.out) == PictureFormat::gltf) {
    throw UnsupportedError(options.out + ": colours of irradiance are not written as .gltf; take .png or .html");
  }
}

/// What makes sense in space may make none in the plane, and the other way round.
void check_dimension(const RenderOptions& options, int dimension) {
  if (dimension == 2 && !options.camera.empty()) {
    throw UsageError("--camera: a scene of the plane is drawn as it is; " + options.scene + " has dimension 2");
  }
  if (dimension == 2 && !options.up.empty()) {
    throw UsageError("--up: a scene of the plane is drawn as it is; " + options.scene + " has dimension 2");
  }
  if (dimension == 2 && options.volumes) {
    throw UsageError("--volumes: regions of the plane are always drawn; " + options.scene + " has dimension 2");
  }
  if (dimension == 3 && picture_format(options.out) == PictureFormat::svg) {
    throw UnsupportedError(options.scene + ": a scene in space is not drawn as .svg; take .png, .html or .gltf");
  }
}

/// A name that an option may ask for.
struct KnownName {
  std::string name;
};

void require_names(const RenderOptions& options, const ResultNames& names) {
  const auto known = [](const std::vector<std::string>& list) {
    return std::vector<KnownName>(list.begin(), list.end());
  };
  require_name("--light", "light with results", options.light, known(names.lights));
  require_name("--receiver", "receiver", options.receiver, known(names.receivers));
}

ExitCode render_folder(const RenderOptions& options, const PictureOptions& picture) {
  if (!options.box.empty() || !options.blocker.empty()) {
    throw UsageError("--box and --blocker choose what is computed of a scene; " + options.scene +
                     " is a folder of results");
  }
  if (std::error_code error; !fs::exists(fs::path(options.scene) / "manifest.json", error)) {
    throw SceneError(options.scene +
                     ": the folder holds no manifest.json; expected a folder that a command of gnomon has written");
  }
  check_dimension(options, result_dimension(options.scene));
  check_colour(options, result_dimension(options.scene), true);
  require_names(options, result_names(options.scene));
  draw(options, [&] { render_result(options.scene, options.out, picture); });
  return ExitCode::done;
}

/// The light of the picture; empty for all, which only a page can show.
std::string shown_light(const RenderOptions& options, const Scene& scene) {
  if (!options.light.empty() || picture_format(options.out) == PictureFormat::html) return options.light;
  const auto first = [](const auto& some) { return some.lights.empty() ? "" : some.lights.front().name; };
  return std::visit(first, scene);
}

/// Parts of one blocker hide each other, and their umbrae are not the umbra of the whole. Irradiance behind volumes
/// would have other colours than the scale.
std::vector<ScenePair> drawn_pairs(const RenderOptions& options, const Scene& scene, std::vector<ScenePair> pairs) {
  const auto* space = std::get_if<SpaceScene>(&scene);
  if (!space || options.volumes) return pairs;
  if (shows_irradiance(options)) return {};
  std::erase_if(pairs, [&](const ScenePair& p) { return p.blocker != space->blockers[p.blocker_index].name; });
  return pairs;
}

void warn_of_missing(const std::vector<ScenePair>& all, const std::vector<ScenePair>& drawn,
                     const ShadowResult& result) {
  if (supported_count(drawn) < drawn.size()) print_warning(unsupported_text(drawn));
  if (!all.empty() && drawn.empty() && result.receivers.empty()) {
    print_warning(
        "the picture shows no shadow: no receiver is divided, and the volumes of blockers of several convex "
        "parts are drawn with --volumes only");
  }
}

ExitCode render_scene_file(const RenderOptions& options, const PictureOptions& picture) {
  const Scene scene = scene_file_with_warnings(options.scene);
  check_dimension(options, dimension(scene));
  check_colour(options, dimension(scene), false);
  const std::string light = shown_light(options, scene);
  const std::vector<ScenePair> all = scene_pairs(scene, {light, options.blocker});
  const std::vector<ScenePair> pairs = drawn_pairs(options, scene, all);
  const Box3 box = clip_box(scene, options.box);
  const Effort effort{options.threads, !options.quiet};
  std::vector<ReceiverResult> receivers = receivers_beside_volumes(scene, {light, options.receiver}, effort);
  if (!pairs.empty() && supported_count(pairs) == 0 && receivers.empty()) {
    throw UnsupportedError(facts(scene).source + ": " + unsupported_text(pairs));
  }
  ShadowResult result = computed_shadows(scene, pairs, box, effort);
  result.receivers = std::move(receivers);
  if (shows_irradiance(options)) {
    result.painted = painted_receivers(std::get<SpaceScene>(scene), result.receivers, effort);
    if (result.painted.empty()) print_warning("the picture shows no irradiance: no receiver is divided");
  }
  draw(options, [&] { render_scene(result, options.out, picture); });
  warn_of_missing(all, pairs, result);
  return ExitCode::done;
}

}  // namespace

ExitCode render_command(Arguments arguments) {
  CommandLine app(
      "Makes a picture of lights, blockers, receivers and shadow volumes: pixels, a drawing, or a page that turns.",
      "gnomon render");
  RenderOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  const PictureOptions picture = picture_options(options);
  std::error_code error;
  const bool is_folder = fs::is_directory(options.scene, error);
  const ExitCode code = is_folder ? render_folder(options, picture) : render_scene_file(options, picture);
  if (!options.quiet) std::cout << "written    " << shell_word(options.out) << '\n';
  return code;
}

}  // namespace gnomon
