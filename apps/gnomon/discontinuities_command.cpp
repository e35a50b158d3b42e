#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/discontinuity_output.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/scene_discontinuities.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/shadow_json.h"
#include "apps/gnomon/text.h"
#include "gnomon/scene.h"
#include "viz/vtk/discontinuity_writer.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

struct DiscontinuitiesOptions : CommonOptions {
  std::string out;
  std::string format = "vtm";
};

void add_options(CommandLine& app, DiscontinuitiesOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_text(app, "--out", options.out, "DIR", "Folder for the files; may be left out where --json is given");
  add_json_option(app, options);
  add_text(app, "--light", options.light, "NAME", "Only this light");
  add_text(app, "--box", options.box, "xmin,ymin,zmin,xmax,ymax,zmax", "Cut the surfaces by this box");
  add_text(app, "--format", options.format, "LIST", "One or both of vtm,vtpc (default: vtm)");
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Each surface is the part of a plane on which a vertex and an edge are in line with the light, from the farther\n"
      "of the two to the first blocker or receiver. Its order is the lowest derivative of the visible fraction that\n"
      "may jump there.\n\n"
      "Examples:\n"
      "  gnomon discontinuities examples/figure_4_22.scene.json --out surfaces\n"
      "  gnomon discontinuities examples/cornell_box.scene.json --json -\n");
}

Json element_json(const DiscontinuityResult& result, const std::string& light, const EventElement& element) {
  return {{"of", element_text(result, light, "", element)}, {"index", number(element.index)}};
}

Json surface_json(const DiscontinuityResult& result, const std::string& light, const EventName& event) {
  Json json = {{"vertex", element_json(result, light, event.vertex)},
               {"edge", element_json(result, light, event.edge)},
               {"order", event.order}};
  if (event.extremal != Extremal::none) json["extremal"] = name(event.extremal);
  return json;
}

Json discontinuities_json(const DiscontinuityResult& result) {
  Json document = {{"schema", "gnomon/discontinuities/1"},
                   {"scene", facts(*result.scene).source},
                   {"length_unit", facts(*result.scene).length_unit},
                   {"clip_box", box_json(result.clip_box, 3)},
                   {"lights", Json::array()}};
  for (const SurfaceResult& light : result.surfaces) {
    Json surfaces = Json::array();
    for (const DiscontinuitySurface& surface : light.surfaces) {
      surfaces.push_back(surface_json(result, light.light, surface.name));
    }
    document["lights"].push_back({{"name", light.light}, {"surfaces", std::move(surfaces)}});
  }
  return document;
}

std::string summary(const DiscontinuityResult& result) {
  std::string text;
  for (const SurfaceResult& light : result.surfaces) {
    std::array<std::size_t, 3> counts{};
    for (const DiscontinuitySurface& surface : light.surfaces) ++counts[surface.name.order];
    text += light.light + ": " + counted(light.surfaces.size(), "surface") + " (D0 " + std::to_string(counts[0]) +
            ", D1 " + std::to_string(counts[1]) + ", D2 " + std::to_string(counts[2]) + ")\n";
  }
  return text;
}

}  // namespace

ExitCode discontinuities_command(Arguments arguments) {
  CommandLine app(
      "Computes the surfaces in space across which the visible fraction of a light changes its formula because an\n"
      "edge and a vertex are in line, with their order D0, D1 or D2.",
      "gnomon discontinuities");
  DiscontinuitiesOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  if (options.out.empty() && options.json.empty()) {
    throw UsageError("nothing to write: give a folder with --out, or a file with --json");
  }
  const std::vector<OutputFormat> formats = tree_formats(options.format);
  require_result_places(options.out, options.json, {options.scene});
  const Scene scene = scene_file_with_warnings(options.scene);
  const Box3 box = clip_box(scene, options.box);
  const DivisionPlan plan = division_plan(scene, {options.light, {}}, DivisionOf::surfaces);
  tell_left_out(plan);
  const DiscontinuityResult result = scene_surfaces(plan, box, {options.threads, !options.quiet});
  std::vector<std::filesystem::path> files;
  if (!options.out.empty()) {
    files = write_discontinuities(result, DiscontinuityOutput::discontinuities, options.out, formats);
    warn_of_outdated_results(options.out);
  }
  if (!options.json.empty()) write_json(discontinuities_json(result), options.json);
  if (!options.quiet && options.json != "-") std::cout << summary(result) << written_files_text(options.out, files);
  return ExitCode::done;
}

}  // namespace gnomon
