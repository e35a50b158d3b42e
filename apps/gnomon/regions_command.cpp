#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/linear_search_option.h"
#include "apps/gnomon/output_file.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/point_batches.h"
#include "apps/gnomon/point_table.h"
#include "apps/gnomon/region_finder.h"
#include "apps/gnomon/regions_output.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/text.h"
#include "geometry/parallel.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

struct RegionsOptions : CommonOptions {
  std::string at;
  std::string out;
};

void add_options(CommandLine& app, RegionsOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_required_text(
      app, "--at", options.at, "POINTS.csv|-",
      "Points as CSV with columns x,y,z (x,y in the plane) or x,y,z,nx,ny,nz, or so many numbers a line without a\n"
      "header; '-' reads them from stdin. Commas, semicolons, tabs or blanks separate; further columns are\n"
      "passed through");
  add_text(app, "--out", options.out, "FILE", "Write the CSV to this file (default: to stdout)");
  add_json_option(app, options);
  add_text(app, "--light", options.light, "NAME", "Only this light");
  add_linear_search_option(app, options);
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Each row of the result is a row of the input, followed by light,region,visible_fraction,error_bound. The "
      "region\n"
      "(lit, penumbra, umbra or unlit) is decided exactly. A malformed line is reported with its number and left out;\n"
      "the exit code is 3 then.\n\n"
      "Points with normals are those of receivers: of a light only what lies before the receiver counts, of which\n"
      "region and visible_fraction tell, with its share of the light as a column before_receiver. They are lit or in\n"
      "penumbra exactly where they get light. A facet right under a point does not hide the light from it.\n\n"
      "Examples:\n"
      "  gnomon regions examples/figure_4_22.scene.json --at examples/points.csv\n"
      "  gnomon regions examples/two_lamps.scene.json --at examples/points.csv --json -\n");
}

std::vector<JudgedRow> judged_batch(PointTable& table, const RegionFinder& finder) {
  std::vector<JudgedRow> rows;
  for (TableRow& row : next_rows(table)) rows.push_back({std::move(row), {}});
  for_all(rows.size(), finder.threads, [&](std::size_t i, std::size_t worker) {
    const auto* row = std::get_if<PointRow>(&rows[i].row);
    if (!row) return;
    rows[i].seen = table.has_normals() ? finder.received(worker, row->coordinates, row->normal)
                                       : finder.at(worker, row->coordinates);
    rows[i].is_within_rounding =
        !table.has_normals() && finder.is_within_rounding && finder.is_within_rounding(row->coordinates);
  });
  return rows;
}

TableColumns columns_of(const Scene& scene) {
  return std::holds_alternative<PlaneScene>(scene) ? TableColumns::planar_points
                                                   : TableColumns::points_perhaps_with_normals;
}

void warn_of_rounding(std::size_t within, std::size_t points) {
  if (within == 0) return;
  print_warning(counted(within, "point") + " of " + std::to_string(points) +
                " within rounding of a blocker: which side of it the answer is for, their coordinates alone do not "
                "tell. Points of a surface want its normals, as columns nx,ny,nz");
}

/// Where the results go: any of a CSV file or stdout, and a JSON file or stdout.
struct RegionsOutputs {
  std::optional<OutputFile> csv_file;
  std::optional<OutputFile> json_file;
  std::optional<RegionsCsv> csv;
  std::optional<RegionsJson> json;

  RegionsOutputs(const RegionsOptions& options, const Scene& scene, const PointTable& table,
                 const std::vector<std::string>& lights) {
    if (!options.out.empty()) csv_file.emplace(options.out);
    const PointKind kind = table.has_normals() ? PointKind::of_receivers : PointKind::bare;
    if (csv_file || options.json != "-") {
      csv.emplace(csv_file ? csv_file->stream() : std::cout, table.header(), lights, kind);
    }
    if (options.json.empty()) return;
    if (options.json != "-") json_file.emplace(options.json);
    json.emplace(json_file ? json_file->stream() : std::cout, scene, lights, kind);
  }

  void add(const JudgedRow& judged) {
    if (csv) csv->add(judged);
    if (json) json->add(judged);
  }

  void publish(const RegionCounts& counts) {
    if (json) json->finish(counts);
    if (csv_file) csv_file->publish();
    if (json_file) json_file->publish();
  }
};

ExitCode write_regions(const RegionsOptions& options, const Scene& scene, std::istream& stream,
                       const std::string& file) {
  const RegionFinder finder = region_finder(scene, options.light, options.threads, linear_search(options, scene));
  PointTable table(stream, file, columns_of(scene));
  RegionsOutputs outputs(options, scene, table, finder.lights);
  RegionCounts counts(finder.lights);
  std::size_t within_rounding = 0;
  if (finder.lights.empty()) print_warning("the scene has no light");
  Progress progress("point", 0, progress_visibility(options.quiet, options.out.empty()));
  for (auto rows = judged_batch(table, finder); !rows.empty(); rows = judged_batch(table, finder)) {
    for (const JudgedRow& judged : rows) {
      counts.add(judged);
      within_rounding += judged.is_within_rounding ? 1 : 0;
      outputs.add(judged);
      const auto* malformed = std::get_if<MalformedRow>(&judged.row);
      if (malformed) print_error(file + ':' + std::to_string(malformed->line) + ": " + malformed->problem);
    }
    // Who reads a pipe gets every batch; who went away need not be served, unless there is a file to be written, too.
    if (!outputs.json_file) finish_stdout();
    progress.step(rows.size());
    progress.set_share(share_read(stream, options.at));
  }
  outputs.publish(counts);
  warn_of_rounding(within_rounding, counts.points());
  if (!options.quiet && !options.out.empty() && options.json != "-") std::cout << counts.text();
  return counts.malformed_lines() == 0 ? ExitCode::done : ExitCode::bad_scene;
}

}  // namespace

ExitCode regions_command(Arguments arguments) {
  CommandLine app(
      "Tells for points what they receive of each light behind all blockers together: the region, decided\n"
      "exactly, the visible fraction of the light, and a bound of its error.",
      "gnomon regions");
  RegionsOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  require_table_places(options.out, options.json, {options.scene, options.at});
  if (options.out == "-") options.out.clear();
  const Scene scene = scene_file_with_warnings(options.scene);
  return with_points(options.at, [&](std::istream& stream, const std::string& file) {
    return write_regions(options, scene, stream, file);
  });
}

}  // namespace gnomon
