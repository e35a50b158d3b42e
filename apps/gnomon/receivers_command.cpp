#include <array>
#include <cstdio>
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
#include "apps/gnomon/receiver_json.h"
#include "apps/gnomon/receiver_reflection.h"
#include "apps/gnomon/scene_discontinuities.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/shadow_json.h"
#include "apps/gnomon/text.h"
#include "gnomon/scene.h"
#include "viz/vtk/discontinuity_writer.h"

namespace gnomon {
namespace {

struct ReceiversOptions : CommonOptions {
  std::string out;
  std::string receiver;
  std::string format = "vtm";
  std::string mesh;
  ReceiverViews seen;
};

void add_options(CommandLine& app, ReceiversOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_text(app, "--out", options.out, "DIR",
           "Folder for the files; without it only shares are told, with --json areas");
  add_json_option(app, options);
  add_text(app, "--mesh", options.mesh, "LIST",
           "With --json: tell the mesh too, some of faces,edges,polygons, each by its vertices");
  add_text(app, "--receiver", options.receiver, "NAME", "Only this receiver");
  add_text(app, "--light", options.light, "NAME", "Only this light");
  add_text(
      app, "--eye", options.seen.eye, "x,y,z|camera",
      "With --out or --mesh: also tell irradiance at every vertex, and the radiance that it reflects of the light\n"
      "to an eye here, or to that of the scene's camera");
  add_text(app, "--material", options.seen.material, "NAME",
           "With --eye: what receivers are made of (default: each of its own, as for gnomon radiance)");
  add_text(app, "--box", options.box, "xmin,ymin,zmin,xmax,ymax,zmax", "The box that is written as clip_box");
  add_text(app, "--format", options.format, "LIST", "One or both of vtm,vtpc (default: vtm)");
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Each receiver is divided by every discontinuity; of those of three edges in line, which are arcs of conics, by\n"
      "those that bound an umbra. Faces are labelled lit, penumbra, umbra or unlit. Only what of the light lies\n"
      "strictly before a receiver's plane counts. Unlit is what has nothing of it before, or sees its back or its\n"
      "edge. Areas are in squares of the scene's unit of length.\n"
      "With --eye the files have the point arrays irradiance and irradiance_error_bound in W/m^2, radiance and\n"
      "radiance_error_bound in W/(m^2 sr), red, green and blue, of the vertices as doubles; the JSON's meshes too.\n\n"
      "Examples:\n"
      "  gnomon receivers examples/cornell_box.scene.json --receiver floor\n"
      "  gnomon receivers examples/still_life.scene.json --out life --eye camera\n");
}

std::string percentage(double part, double whole) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f %%", 100 * part / whole);
  return text.data();
}

std::string receivers_summary(const DiscontinuityResult& result) {
  std::string text;
  for (const SideResult side : sides_of(result.receivers)) {
    const SideCounts counts = counts_of(side);
    const std::string facets = side.size() > 1 ? counted(side.size(), "facet") + ", " : "";
    text += in_columns(side.front().side + ", light " + side.front().light + ": " + facets +
                       counted(counts.faces, "face") + ", " + counted(counts.regions, "region"));
    std::string shares;
    const auto areas = areas_of(side);
    const double whole = counts.area;
    for (std::size_t k = 0; k < areas.size(); ++k) {
      if (areas[k].nearest == 0) continue;
      shares += " " + std::string(name(static_cast<ReceiverRegion>(k))) + " " + percentage(areas[k].nearest, whole);
    }
    text += " " + shares + "\n";
  }
  return text;
}

ExitCode write_all(const ReceiversOptions& options, const std::vector<OutputFormat>& formats, const Scene& scene) {
  const VertexFractions fractions = options.out.empty() ? VertexFractions::left_out : VertexFractions::worked_out;
  const Effort effort{options.threads, !options.quiet};
  const DivisionPlan plan = division_plan(scene, {options.light, options.receiver}, DivisionOf::receivers);
  tell_left_out(plan);
  DiscontinuityResult result = divided_receivers(plan, fractions, effort);
  if (!options.seen.eye.empty()) add_reflection(result, plan, options.seen, effort);
  std::vector<std::filesystem::path> files;
  if (!options.out.empty()) {
    result.clip_box = clip_box(scene, options.box);
    files = write_discontinuities(result, DiscontinuityOutput::receivers, options.out, formats);
    warn_of_outdated_results(options.out);
  }
  if (!options.json.empty()) write_json(receivers_json(result, mesh_parts(options.mesh)), options.json);
  if (result.receivers.empty()) print_warning("the scene has no pair of a light and a receiver");
  if (!options.quiet && options.json != "-") {
    std::cout << receivers_summary(result) << written_files_text(options.out, files);
  }
  return ExitCode::done;
}

}  // namespace

ExitCode receivers_command(Arguments arguments) {
  CommandLine app(
      "Divides each receiver by what it receives of each light behind all blockers together: exact regions, their\n"
      "areas, and the mesh of all discontinuities.",
      "gnomon receivers");
  ReceiversOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  const std::vector<OutputFormat> formats = tree_formats(options.format);
  if (mesh_parts(options.mesh).any() && options.json.empty()) throw UsageError("--mesh goes with --json FILE");
  if (options.seen.eye.empty() && !options.seen.material.empty()) {
    throw UsageError("--material NAME goes with --eye x,y,z");
  }
  if (!options.seen.eye.empty() && options.out.empty() && !mesh_parts(options.mesh).any()) {
    throw UsageError("--eye x,y,z goes with --out DIR, or with --json FILE and --mesh LIST");
  }
  require_result_places(options.out, options.json, {options.scene});
  return write_all(options, formats, scene_file_with_warnings(options.scene));
}

}  // namespace gnomon
