#include <CLI/CLI.hpp>
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
#include "apps/gnomon/scene_discontinuities.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/shadow_json.h"
#include "apps/gnomon/text.h"
#include "geometry/discontinuity/total_area.h"
#include "geometry/scene/scene_reader.h"
#include "viz/discontinuity_writer.h"

namespace gnomon {
namespace {

struct ReceiversOptions : CommonOptions {
  std::string out;
  std::string receiver;
  std::string format = "vtm";
};

void add_options(CLI::App& app, ReceiversOptions& options) {
  add_text(app, "SCENE", options.scene, "FILE", "Scene file")->required();
  add_text(app, "--out", options.out, "DIR", "Folder for the files; without it only areas are told");
  add_json_option(app, options);
  add_text(app, "--receiver", options.receiver, "NAME", "Only this receiver");
  add_text(app, "--light", options.light, "NAME", "Only this light");
  add_text(app, "--box", options.box, "xmin,ymin,zmin,xmax,ymax,zmax", "The box that is written as clip_box");
  add_text(app, "--format", options.format, "LIST", "One or both of vtm,vtpc (default: vtm)");
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Each receiver is divided by every discontinuity but those of three edges in line. Faces are labelled lit,\n"
      "penumbra, umbra, unlit, or unresolved_eee where three edges in line may separate penumbra and umbra inside a\n"
      "face. Only what of the light lies strictly before a receiver's plane counts. Unlit is what has nothing of it\n"
      "before, or sees its back or its edge. Areas are in squares of the scene's unit of length.\n\n"
      "Examples:\n"
      "  gnomon receivers examples/cornell_box.scene.json --light ceiling_lamp --receiver floor\n"
      "  gnomon receivers examples/figure_4_22.scene.json --out floor_mesh --json -\n");
}

nlohmann::ordered_json areas_json(SideResult side) {
  nlohmann::ordered_json json;
  const auto areas = areas_of(side);
  for (std::size_t k = 0; k < areas.size(); ++k) {
    nlohmann::ordered_json area = {{"double", areas[k].nearest}};
    if (areas[k].exact) area["exact"] = *areas[k].exact;
    json[std::string(name(static_cast<ReceiverRegion>(k)))] = std::move(area);
  }
  return json;
}

/// Sums over the pieces of a side.
struct SideCounts {
  double area = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::size_t vertices = 0;
  std::size_t regions = 0;
};

SideCounts counts_of(SideResult side) {
  SideCounts counts;
  std::vector<RegionArea> areas;
  for (const ReceiverResult& piece : side) {
    areas.push_back(piece.mesh.area());
    counts.faces += piece.mesh.faces().size();
    counts.edges += piece.mesh.edges().size();
    counts.vertices += piece.mesh.vertex_count();
    counts.regions += piece.mesh.regions().size();
  }
  counts.area = total_area(areas).nearest;
  return counts;
}

nlohmann::ordered_json receivers_json(const DiscontinuityResult& result) {
  nlohmann::ordered_json document = {{"schema", "gnomon/receivers/1"},
                                     {"scene", result.scene->source},
                                     {"length_unit", result.scene->length_unit},
                                     {"area_unit", result.scene->length_unit + "^2"},
                                     {"receivers", nlohmann::ordered_json::array()}};
  for (const SideResult side : sides_of(result.receivers)) {
    const SideCounts counts = counts_of(side);
    document["receivers"].push_back({{"name", side.front().side},
                                     {"light", side.front().light},
                                     {"area", counts.area},
                                     {"faces", counts.faces},
                                     {"edges", counts.edges},
                                     {"vertices", counts.vertices},
                                     {"regions", counts.regions},
                                     {"areas", areas_json(side)}});
    if (side.size() > 1) document["receivers"].back()["facets"] = side.size();
  }
  return document;
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
    text += side.front().side + ", light " + side.front().light + ": ";
    if (side.size() > 1) text += counted(side.size(), "facet") + ", ";
    text += counted(counts.faces, "face") + ", " + counted(counts.regions, "region") + ";";
    const auto areas = areas_of(side);
    const double whole = counts.area;
    for (std::size_t k = 0; k < areas.size(); ++k) {
      if (areas[k].nearest == 0) continue;
      text += " " + std::string(name(static_cast<ReceiverRegion>(k))) + " " + percentage(areas[k].nearest, whole);
    }
    text += "\n";
  }
  return text;
}

ExitCode write_all(const ReceiversOptions& options, const std::vector<OutputFormat>& formats, const Scene& scene) {
  const VertexFractions fractions = options.out.empty() ? VertexFractions::left_out : VertexFractions::worked_out;
  const Effort effort{options.threads, !options.quiet};
  DiscontinuityResult result = divided_receivers(scene, {options.light, options.receiver}, fractions, effort);
  std::vector<std::filesystem::path> files;
  if (!options.out.empty()) {
    result.clip_box = clip_box(scene, options.box);
    files = write_discontinuities(result, DiscontinuityOutput::receivers, options.out, formats);
  }
  if (!options.json.empty()) write_json(receivers_json(result), options.json);
  if (result.receivers.empty()) print_warning("the scene has no pair of a light and a receiver");
  if (!options.quiet && options.json != "-") {
    std::cout << receivers_summary(result) << written_files_text(options.out, files);
  }
  return ExitCode::done;
}

}  // namespace

ExitCode receivers_command(Arguments arguments) {
  CLI::App app(
      "Divides each receiver by what it receives of each light behind all blockers together: exact regions, their\n"
      "areas, and the mesh of all discontinuities.",
      "gnomon receivers");
  ReceiversOptions options;
  add_options(app, options);
  if (!parse_arguments(app, arguments)) return ExitCode::done;
  const std::vector<OutputFormat> formats = tree_formats(options.format);
  return write_all(options, formats, scene_file_with_warnings(options.scene));
}

}  // namespace gnomon
