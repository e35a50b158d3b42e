#include <charconv>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/computed_shadows.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/scene_pairs.h"
#include "apps/gnomon/shadow_summary.h"
#include "apps/gnomon/text.h"
#include "geometry/scene/scene_reader.h"
#include "viz/picture.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

constexpr int smallest_side = 64;
constexpr int largest_side = 16384;

struct RenderOptions : CommonOptions {
  std::string out;
  std::string size;
};

void add_options(CLI::App& app, RenderOptions& options) {
  add_text(app, "SCENE|DIR", options.scene, "PATH", "Scene file, or a folder written by 'gnomon shadow'")->required();
  add_text(app, "--out", options.out, "FILE.png", "The picture, a PNG file")->required();
  add_text(app, "--size", options.size, "WxH", "Width and height in pixels (default: 1280x960)");
  add_pair_options(app, options);
  app.footer(
      "Without a screen: xvfb-run -a -s \"-screen 0 1280x1024x24 -noreset\" gnomon render ...\n\n"
      "Examples:\n"
      "  gnomon render examples/figure_4_22.scene.json --out figure_4_22.png\n"
      "  gnomon render examples/cornell_box.scene.json --blocker tall_top --out tall_top.png --size 800x600\n");
}

int side_from_text(std::string_view text, const std::string& option) {
  int side = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
  const bool is_number = error == std::errc{} && end == text.data() + text.size();
  if (is_number && side >= smallest_side && side <= largest_side) return side;
  throw UsageError("--size " + option + ": expected WIDTHxHEIGHT, each from " + std::to_string(smallest_side) + " to " +
                   std::to_string(largest_side));
}

PictureOptions picture_options(const std::string& size) {
  if (size.empty()) return {};
  const std::size_t cross = std::min(size.find('x'), size.size());
  const std::string_view text = size;
  const std::string_view height = text.substr(std::min(cross + 1, size.size()));
  return {side_from_text(text.substr(0, cross), size), side_from_text(height, size)};
}

ExitCode render_folder(const RenderOptions& options, const PictureOptions& picture) {
  if (!options.box.empty() || !options.light.empty() || !options.blocker.empty()) {
    throw UsageError("--box, --light and --blocker choose what is computed of a scene; " + options.scene +
                     " is a folder of results");
  }
  if (std::error_code error; !fs::exists(fs::path(options.scene) / "manifest.json", error)) {
    throw SceneError(options.scene +
                     ": the folder holds no manifest.json; expected a folder written by 'gnomon shadow'");
  }
  render_result(options.scene, options.out, picture);
  return ExitCode::done;
}

ExitCode render_scene_file(const RenderOptions& options, const PictureOptions& picture) {
  const Scene scene = read_scene(options.scene);
  const std::vector<ScenePair> pairs = scene_pairs(scene, {options.light, options.blocker});
  const Box3 box = clip_box(scene, options.box);
  if (!pairs.empty() && supported_count(pairs) == 0) {
    throw UnsupportedError(scene.source + ": " + unsupported_text(pairs));
  }
  render_scene(computed_shadows(scene, pairs, box, {options.threads, !options.quiet}), options.out, picture);
  if (supported_count(pairs) < pairs.size()) print_warning(unsupported_text(pairs));
  return ExitCode::done;
}

}  // namespace

ExitCode render_command(Arguments arguments) {
  CLI::App app("Makes a picture of lights, blockers, receivers and shadow volumes.", "gnomon render");
  RenderOptions options;
  add_options(app, options);
  if (!parse_arguments(app, arguments)) return ExitCode::done;
  const PictureOptions picture = picture_options(options.size);
  std::error_code error;
  const bool is_folder = fs::is_directory(options.scene, error);
  const ExitCode code = is_folder ? render_folder(options, picture) : render_scene_file(options, picture);
  if (!options.quiet) std::cout << "written    " << shell_word(options.out) << '\n';
  return code;
}

}  // namespace gnomon
