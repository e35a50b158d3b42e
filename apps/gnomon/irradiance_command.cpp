#include <tbb/enumerable_thread_specific.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/element_choice.h"
#include "apps/gnomon/irradiance_output.h"
#include "apps/gnomon/output_file.h"
#include "apps/gnomon/point_batches.h"
#include "apps/gnomon/receiver_rows.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/scene_obstacles.h"
#include "apps/gnomon/text.h"
#include "geometry/scene/scene_reader.h"
#include "shading/light_irradiance.h"
#include "shading/receiver_grid.h"
#include "shading/unit_conversion.h"

namespace gnomon {
namespace {

struct IrradianceOptions : CommonOptions {
  std::string at;
  std::string on;
  std::string shape;
  std::string out;
};

void add_options(CLI::App& app, IrradianceOptions& options) {
  add_text(app, "SCENE", options.scene, "FILE", "Scene file")->required();
  add_text(app, "--at", options.at, "POINTS.csv|-",
           "Receivers as CSV with columns x,y,z,nx,ny,nz, or six numbers a line without a header; '-' reads them from\n"
           "stdin. Commas, semicolons, tabs or blanks separate; further columns are passed through");
  add_text(app, "--on", options.on, "RECEIVER", "Points spread over this receiver of the scene, seen from its front");
  add_text(app, "--shape", options.shape, "nu,nv",
           "With --on: the number of points along the receiver's first side and at right angles to it. They are the\n"
           "middles of equal cells of the smallest such rectangle; those beside the receiver are left out");
  add_text(app, "--out", options.out, "FILE", "Write the CSV to this file (default: to stdout)");
  add_json_option(app, options);
  add_text(app, "--light", options.light, "NAME", "Only this light");
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Each row of the result is a row of the input, or x,y,z,nx,ny,nz of a point on the receiver, followed by\n"
      "light,irradiance,error_bound. Irradiance is in W/m^2 whatever the scene's unit of length, and clipped by the\n"
      "receiver's horizon; |irradiance - exact| is at most error_bound. A malformed line is reported with its number\n"
      "and left out; the exit code is 3 then.\n\n"
      "Examples:\n"
      "  gnomon irradiance examples/figure_4_22.scene.json --at examples/receivers.csv\n"
      "  gnomon irradiance examples/figure_4_22.scene.json --on floor --shape 20,20 --json -\n");
}

/// One set of lights per thread: each keeps memory for the next question.
using LightsOfThreads = tbb::enumerable_thread_specific<std::vector<LightIrradiance>>;

std::vector<LitRow> lit_rows(std::vector<TableRow> batch, const std::vector<const SceneLight*>& chosen,
                             const LengthUnit& unit, LightsOfThreads& lights, tbb::task_arena& threads) {
  std::vector<LitRow> rows;
  for (TableRow& row : batch) rows.push_back({std::move(row), {}});
  for_all(rows.size(), threads, [&](std::size_t i) {
    const auto* row = std::get_if<PointRow>(&rows[i].row);
    if (!row) return;
    const auto& p = row->coordinates;
    const auto& n = row->normal;
    std::vector<LightIrradiance>& local = lights.local();
    for (std::size_t l = 0; l < local.size(); ++l) {
      const Irradiance e = local[l].at({p[0], p[1], p[2]}, {n[0], n[1], n[2]});
      rows[i].received.push_back(per_square_metre(e, chosen[l]->shape, unit));
    }
  });
  return rows;
}

/// Where the results go: any of a CSV file or stdout, and a JSON file or stdout.
struct IrradianceOutputs {
  std::optional<OutputFile> csv_file;
  std::optional<OutputFile> json_file;
  std::optional<IrradianceCsv> csv;
  std::optional<IrradianceJson> json;

  IrradianceOutputs(const IrradianceOptions& options, const Scene& scene, const std::string& header,
                    const std::vector<std::string>& lights) {
    if (!options.out.empty()) csv_file.emplace(options.out);
    if (csv_file || options.json != "-") csv.emplace(csv_file ? csv_file->stream() : std::cout, header, lights);
    if (options.json.empty()) return;
    if (options.json != "-") json_file.emplace(options.json);
    json.emplace(json_file ? json_file->stream() : std::cout, scene, lights);
  }

  void publish(std::size_t points, std::size_t malformed_lines) {
    if (json) json->finish(points, malformed_lines);
    if (csv_file) csv_file->publish();
    if (json_file) json_file->publish();
  }
};

/// Where the rows come from.
struct Receivers {
  std::string file;                                   ///< as messages call it
  std::string header;                                 ///< the columns that the result repeats
  std::function<std::vector<TableRow>()> next_batch;  ///< none at the end
  Obstacles obstacles;
  std::size_t count = 0;  ///< of rows; 0 if nobody knows
};

ExitCode write_irradiance(const IrradianceOptions& options, const Scene& scene, Receivers receivers) {
  const std::vector<const SceneLight*> chosen = chosen_lights(scene.lights, options.light);
  const PreparedObstacles obstacles(std::move(receivers.obstacles));
  LightsOfThreads lights([&] {
    std::vector<LightIrradiance> result;
    for (const SceneLight* light : chosen) result.emplace_back(light->shape, light->strength, obstacles);
    return result;
  });
  const LengthUnit unit = *length_unit_named(scene.length_unit);
  std::vector<std::string> names;
  for (const SceneLight* light : chosen) names.push_back(light->name);
  IrradianceOutputs outputs(options, scene, receivers.header, names);
  tbb::task_arena threads(arena_size(options.threads));
  if (names.empty()) print_warning("the scene has no light");
  Progress progress("point", receivers.count, progress_visibility(options.quiet, options.out.empty()));
  std::size_t points = 0;
  std::size_t malformed_lines = 0;
  for (auto batch = receivers.next_batch(); !batch.empty(); batch = receivers.next_batch()) {
    const std::size_t count = batch.size();
    for (const LitRow& lit : lit_rows(std::move(batch), chosen, unit, lights, threads)) {
      if (outputs.csv) outputs.csv->add(lit);
      if (outputs.json) outputs.json->add(lit);
      const auto* malformed = std::get_if<MalformedRow>(&lit.row);
      ++(malformed ? malformed_lines : points);
      if (malformed) print_error(receivers.file + ':' + std::to_string(malformed->line) + ": " + malformed->problem);
    }
    finish_stdout();
    progress.step(count);
  }
  outputs.publish(points, malformed_lines);
  return malformed_lines == 0 ? ExitCode::done : ExitCode::bad_scene;
}

ExitCode at_points(const IrradianceOptions& options, const Scene& scene) {
  return with_points(options.at, [&](std::istream& stream, const std::string& file) {
    PointTable table(stream, file, TableColumns::points_with_normals);
    return write_irradiance(options, scene,
                            {file, table.header(), [&] { return next_rows(table); }, obstacles_of(scene), 0});
  });
}

ExitCode on_receiver(const IrradianceOptions& options, const Scene& scene) {
  require_name("--on", "receiver", options.on, scene.receivers);
  const auto receiver = std::find_if(scene.receivers.begin(), scene.receivers.end(),
                                     [&](const SceneReceiver& r) { return r.name == options.on; });
  if (receiver == scene.receivers.end()) {
    throw UsageError("--on: receiver '" + options.on + "' is taken as parts; name one of them, such as '" + options.on +
                     "#0'");
  }
  const ReceiverGrid grid(receiver->shape, whole_numbers<2>("--shape", options.shape, "nu,nv"));
  std::size_t next = 0;
  return write_irradiance(options, scene,
                          {receiver->name, "x,y,z,nx,ny,nz", [&] { return next_rows(grid, next); },
                           obstacles_before(receiver->shape, obstacles_of(scene)), grid.size()});
}

}  // namespace

ExitCode irradiance_command(Arguments arguments) {
  CLI::App app(
      "Tells for receivers, points with normals, the irradiance that each light gives them behind all blockers\n"
      "together, and a bound of its error.",
      "gnomon irradiance");
  IrradianceOptions options;
  add_options(app, options);
  if (!parse_arguments(app, arguments)) return ExitCode::done;
  if (options.at.empty() == options.on.empty()) throw UsageError("expected either --at POINTS.csv or --on RECEIVER");
  if (options.on.empty() != options.shape.empty()) throw UsageError("--on RECEIVER and --shape nu,nv go together");
  const Scene scene = scene_file_with_warnings(options.scene);
  if (scene.dimension != 3) {
    throw UnsupportedError(scene.source + ": irradiance in scenes of dimension 2 is not available in this version");
  }
  return options.on.empty() ? at_points(options, scene) : on_receiver(options, scene);
}

}  // namespace gnomon
