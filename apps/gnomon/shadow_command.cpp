#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/computed_shadows.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/merged_shadows.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/scene_discontinuities.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/scene_pairs.h"
#include "apps/gnomon/shadow_json.h"
#include "apps/gnomon/shadow_series.h"
#include "apps/gnomon/shadow_summary.h"
#include "apps/gnomon/text.h"
#include "gnomon/scene.h"
#include "gnomon/writer.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

struct ShadowOptions : CommonOptions {
  std::string out;
  std::string format = "vtm";
  std::string path;
  std::string merge;  ///< empty if not given; "true" alone, or "all"
};

void add_options(CommandLine& app, ShadowOptions& options) {
  add_text(app, "SCENE", options.scene, "FILE", "Scene file; without it the scene that is built in");
  add_text(app, "--out", options.out, "DIR", "Folder for the files; may be left out where --json is given");
  add_json_option(app, options);
  add_pair_options(app, options);
  add_text(app, "--format", options.format, "LIST", "One or more of vtm,vtpc,vtp,obj,stl,gltf (default: vtm)");
  app.add_flag("--merge", options.merge,
               "Also unite the occlusion volumes of each blocker's parts into one closed surface; '--merge all' those\n"
               "of all blockers together, a surface for each light. 1,000 parts take about a second");
  add_text(app, "--path", options.path, "FILE",
           "Move the light (--light, where there are several) along a path and write a series that ParaView plays, "
           "DIR/shadow.pvd: CSV with the header x,y,z (x,y in the plane), then a position of the light's first vertex "
           "a line");
  app.footer(
      "Receivers are divided into the exact regions of each light asked for behind all blockers together.\n\n"
      "Examples:\n"
      "  gnomon shadow --out shadow_of_default\n"
      "  gnomon shadow examples/cornell_box.scene.json --blocker short_top --json -\n");
}

std::vector<OutputFormat> formats(const std::string& list) {
  std::vector<OutputFormat> found;
  for (const std::string_view word : comma_separated(list)) {
    const std::optional<OutputFormat> format = output_format(word);
    if (!format) {
      throw UsageError("--format: expected some of vtm,vtpc,vtp,obj,stl,gltf, but found '" + std::string(word) + "'");
    }
    found.push_back(*format);
  }
  return found;
}

void check_usage(const ShadowOptions& options) {
  if (options.out.empty() && options.json.empty()) {
    throw UsageError("nothing to write: give a folder with --out, or a file with --json");
  }
  if (!options.merge.empty() && options.merge != "true" && options.merge != "all") {
    throw UsageError("--merge=" + options.merge + ": expected --merge or --merge all");
  }
  require_result_places(options.out, options.json, {options.scene, options.path});
  if (options.out.empty() && options.format != "vtm") throw UsageError("--format goes with --out DIR");
  if (options.path.empty()) return;
  if (options.out.empty()) throw UsageError("--path writes a series into a folder: give one with --out");
  if (!options.json.empty()) throw UsageError("--json tells one result, --path makes many; leave one of them out");
  if (options.format != "vtm") throw UsageError("--path writes vtm files; leave --format out");
  if (!options.merge.empty()) throw UsageError("--merge does not go with --path");
}

std::string written_text(const std::string& out, const std::vector<fs::path>& files) {
  if (files.empty()) return {};
  const auto place = [&out](const fs::path& file) { return shell_word((fs::path(out) / file).string()); };
  std::string text = "\nwritten    " + place(files.front());
  if (files.size() > 1) text += " and " + counted(files.size() - 1, "other file");
  text += '\n';
  if (std::find(files.begin(), files.end(), "view.py") != files.end()) {
    text += "open with  paraview --script=" + place("view.py") + '\n';
  }
  return text;
}

/// Says why nothing is written; a script gets the same as JSON.
ExitCode refuse_all(const Scene& scene, const Box3& box, const std::vector<ScenePair>& pairs, const std::string& json) {
  if (!json.empty()) write_json(shadow_json({&scene, box, {}}, pairs), json);
  print_error(facts(scene).source + ": " + unsupported_text(pairs));
  return ExitCode::unsupported;
}

void warn_of_unmerged(Merging merging, const ShadowResult& result, const std::vector<ScenePair>& pairs) {
  if (merging == Merging::each_blocker) {
    if (result.merged.empty()) print_warning("--merge: no blocker has several parts, all supported");
    return;
  }
  std::string last;
  for (const ScenePair& pair : pairs) {
    const bool is_merged = std::ranges::any_of(
        result.merged, [&](const MergedResult& merged) { return merged.light_id == pair.light_index; });
    if (is_merged || pair.light == last) continue;
    print_warning("--merge all: light '" + pair.light + "' is left out, for some of its pairs are not supported");
    last = pair.light;
  }
}

/// `--merge all` as one word, as the reader of options takes it: what follows a flag could be the scene.
std::vector<std::string> with_merge_in_one_word(Arguments arguments) {
  std::vector<std::string> words;
  for (const std::string& word : arguments) {
    if (word == "all" && !words.empty() && words.back() == "--merge") {
      words.back() += "=all";
    } else {
      words.push_back(word);
    }
  }
  return words;
}

ExitCode write_all(const ShadowOptions& options, const std::vector<OutputFormat>& output_formats, const Scene& scene) {
  if (!options.merge.empty() && std::holds_alternative<PlaneScene>(scene))
    throw UnsupportedError("--merge unites volumes, which need dimension 3");
  const std::vector<ScenePair> pairs = scene_pairs(scene, {options.light, options.blocker});
  const Box3 box = clip_box(scene, options.box);
  if (!pairs.empty() && supported_count(pairs) == 0) return refuse_all(scene, box, pairs, options.json);

  const Effort effort{options.threads, !options.quiet};
  ShadowResult result = computed_shadows(scene, pairs, box, effort);
  const Merging merging = options.merge == "all" ? Merging::all_blockers : Merging::each_blocker;
  if (!options.merge.empty()) {
    result.merged = merged_shadows(std::get<SpaceScene>(scene), pairs, merging, box, effort);
  }
  std::vector<fs::path> files;
  if (!options.out.empty()) {
    result.receivers = receivers_beside_volumes(scene, {options.light, {}}, effort);
    files = write_shadow(result, options.out, {output_formats});
    warn_of_outdated_results(options.out);
  }
  if (!options.json.empty()) write_json(shadow_json(result, pairs), options.json);
  if (pairs.empty()) print_warning("the scene has no pair of a light and a blocker");
  if (!options.merge.empty()) warn_of_unmerged(merging, result, pairs);
  if (supported_count(pairs) < pairs.size()) print_warning(unsupported_text(pairs));
  if (!options.quiet && options.json != "-") {
    std::cout << shadow_summary(result, pairs) << written_text(options.out, files);
  }
  return ExitCode::done;
}

ExitCode write_series(const ShadowOptions& options, const Scene& scene) {
  const WrittenSeries series = write_shadow_series(scene, options, options.path, options.out);
  if (series.unsupported_pairs > 0) {
    print_warning(counted(series.unsupported_pairs, "pair") + " of the series not supported, and left out");
  }
  warn_of_outdated_results(options.out);
  if (!options.quiet) std::cout << counted(series.steps, "place") << '\n' << written_text(options.out, series.files);
  return ExitCode::done;
}

}  // namespace

ExitCode shadow_command(Arguments arguments) {
  CommandLine app(
      "Computes the extremal planes and the exact occlusion, umbra and penumbra volumes of every pair of a\n"
      "light and a blocker, and writes them for ParaView; in scenes of dimension 2 lines and regions.",
      "gnomon shadow");
  ShadowOptions options;
  add_options(app, options);
  const std::vector<std::string> words = with_merge_in_one_word(arguments);
  if (!app.parse(words)) return ExitCode::done;
  check_usage(options);
  const std::vector<OutputFormat> output_formats = formats(options.format);
  const Scene scene = options.scene.empty() ? parse_scene(default_scene_text(), "default", ".")
                                            : scene_file_with_warnings(options.scene);
  return options.path.empty() ? write_all(options, output_formats, scene) : write_series(options, scene);
}

}  // namespace gnomon
