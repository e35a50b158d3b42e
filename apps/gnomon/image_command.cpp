#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/image_output.h"
#include "apps/gnomon/linear_search_option.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/text.h"
#include "gnomon/scene.h"
#include "shading/image/tone.h"

namespace gnomon {
namespace {

struct PaintOptions : CommonOptions {
  std::string out;
  std::string shading = "phong";
  std::string lights = "exact";
  std::uint32_t samples = 1;
  std::string exposure;
};

void add_options(CommandLine& app, PaintOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file with a \"camera\"");
  add_required_text(app, "--out", options.out, "FILE",
                    "Write this file: .png, or .pfm and .vti, which hold radiance itself");
  add_text(app, "--shading", options.shading, "MODE",
           "flat: once a facet, at the mean of its corners; gouraud: at the corners, and interpolated; phong\n"
           "(default): at every place, with normals interpolated where a mesh asks for that");
  add_text(app, "--lights", options.lights, "exact|points:M",
           "exact (default), or every linear and polygon light as M points, for comparison");
  app.add_number("--samples", options.samples, "K", 1, 64, "K x K rays a pixel (default: 1)");
  add_text(app, "--exposure", options.exposure, "X",
           "What radiance is multiplied by in a PNG (default: so that one of a hundred pixels is brighter than 0.8)");
  add_json_option(app, options);
  add_linear_search_option(app, options);
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Every pixel is the radiance that the first surface sends to the eye, with a bound of its error: what is\n"
      "visible of every light is exact, light once reflected is not reflected again. A PNG has the nearest grey\n"
      "levels of the sRGB curve; a PFM the radiance as floats; a .vti the cell arrays radiance,\n"
      "radiance_error_bound, irradiance, irradiance_error_bound, depth, element_id and facet_id.\n\n"
      "Examples:\n"
      "  gnomon image examples/still_life.scene.json --out still_life.png\n"
      "  gnomon image examples/still_life.scene.json --out life.vti --shading gouraud\n");
}

image::ShadingMode shading_mode(const std::string& name) {
  if (name == "flat") return image::ShadingMode::flat;
  if (name == "gouraud") return image::ShadingMode::gouraud;
  if (name == "phong") return image::ShadingMode::phong;
  throw UsageError("--shading: found '" + name + "', expected flat, gouraud or phong");
}

/// 0 for the lights themselves.
std::uint32_t point_count(const std::string& text) {
  if (text == "exact") return 0;
  constexpr std::string_view prefix = "points:";
  const std::optional<double> count =
      text.starts_with(prefix) ? finite_number(text.substr(prefix.size())) : std::nullopt;
  if (!count || *count != std::floor(*count) || *count < 1 || *count > 100000) {
    throw UsageError("--lights: found '" + text + "', expected exact, or points:M with M from 1 to 100000");
  }
  return static_cast<std::uint32_t>(*count);
}

/// 0 for the picture's own.
double exposure_of(const std::string& text) {
  if (text.empty()) return 0;
  const double value = finite_value("--exposure", text, "a number larger than 0");
  if (!(value > 0)) throw UsageError("--exposure: found '" + text + "', expected a number larger than 0");
  return value;
}

/// Throws: UnsupportedError for a scene of the plane, SceneError for one without a camera.
SpaceScene scene_with_camera(const std::string& file) {
  Scene scene = scene_file_with_warnings(file);
  auto* space = std::get_if<SpaceScene>(&scene);
  if (!space) {
    throw UnsupportedError(facts(scene).source + ": pictures with light in scenes of dimension 2 are not available");
  }
  if (space->camera) return std::move(*space);
  throw SceneError(space->source + ": found no camera; expected the key \"camera\" with \"eye\" and \"look_at\"");
}

image::ShadedImage painted(const SpaceScene& scene, const image::ImageOptions& options, bool quiet) {
  const std::size_t pixels = std::size_t{scene.camera->width} * scene.camera->height;
  Progress progress("pixel", pixels, progress_visibility(quiet, false));
  return image::shaded_image(scene, options, [&](std::size_t done) { progress.step(done); });
}

}  // namespace

ExitCode image_command(Arguments arguments) {
  CommandLine app(
      "Makes a picture of a scene as its camera sees it, lit by its lights: certified radiance pixel by pixel,\n"
      "behind all blockers together.",
      "gnomon image");
  PaintOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  require_place("--out", options.out, OutputKind::picture);
  require_place("--json", options.json, OutputKind::json);
  require_unread("--json", options.json, {options.scene});
  image::ImageOptions what{shading_mode(options.shading), point_count(options.lights), options.samples, options.threads,
                           linear_search(options)};
  double exposure = exposure_of(options.exposure);
  if (exposure != 0 && !options.out.ends_with(".png")) throw UsageError("--exposure goes with --out FILE.png");
  const SpaceScene scene = scene_with_camera(options.scene);
  const auto start = std::chrono::steady_clock::now();
  const image::ShadedImage picture = painted(scene, what, options.quiet);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (picture.flattened > 0) {
    print_warning("normals cancel at corners of " + counted(picture.flattened, "facet") + ", shaded flat");
  }
  if (exposure == 0) exposure = image::automatic_exposure(picture);
  write_picture(picture, scene, exposure, options.out);
  const ImageStory story{options.out, options.shading, options.lights, options.samples, exposure, seconds.count()};
  if (!options.json.empty()) write_json(image_json(picture, scene, story), options.json);
  if (!options.quiet && options.json != "-") std::cout << image_text(picture, story);
  return ExitCode::done;
}

}  // namespace gnomon
