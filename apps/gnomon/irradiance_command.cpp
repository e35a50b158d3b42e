#include <tbb/enumerable_thread_specific.h>

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
#include "apps/gnomon/scene_obstacles.h"
#include "geometry/scene/scene_reader.h"
#include "shading/light_irradiance.h"

namespace gnomon {
namespace {

struct IrradianceOptions : CommonOptions {
  std::string at;
  std::string out;
};

void add_options(CLI::App& app, IrradianceOptions& options) {
  add_text(app, "SCENE", options.scene, "FILE", "Scene file")->required();
  add_text(app, "--at", options.at, "POINTS.csv|-",
           "Receivers as CSV with the header x,y,z,nx,ny,nz; '-' reads them from stdin. Further columns are passed\n"
           "through")
      ->required();
  add_text(app, "--out", options.out, "FILE", "Write the CSV to this file (default: to stdout)");
  add_json_option(app, options);
  add_text(app, "--light", options.light, "NAME", "Only this light");
  add_threads_option(app, options);
  app.footer(
      "Each row of the result is a row of the input, followed by light,irradiance,error_bound. Irradiance is clipped "
      "by\n"
      "the receiver's horizon; |irradiance - exact| is at most error_bound. A malformed line is reported with its\n"
      "number and left out; the exit code is 3 then.\n\n"
      "Examples:\n"
      "  gnomon irradiance examples/figure_4_22.scene.json --at examples/receivers.csv\n"
      "  gnomon irradiance examples/cornell_box.scene.json --at examples/receivers.csv --json -\n");
}

/// One set of lights per thread: each keeps memory for the next question.
using LightsOfThreads = tbb::enumerable_thread_specific<std::vector<LightIrradiance>>;

std::vector<LitRow> lit_batch(PointTable& table, LightsOfThreads& lights, tbb::task_arena& threads) {
  std::vector<LitRow> rows;
  for (TableRow& row : next_rows(table)) rows.push_back({std::move(row), {}});
  for_all(rows.size(), threads, [&](std::size_t i) {
    const auto* row = std::get_if<PointRow>(&rows[i].row);
    if (!row) return;
    const auto& p = row->coordinates;
    const auto& n = row->normal;
    for (LightIrradiance& light : lights.local()) {
      rows[i].received.push_back(light.at({p[0], p[1], p[2]}, {n[0], n[1], n[2]}));
    }
  });
  return rows;
}

/// Where the results go: any of a CSV file or stdout, and a JSON file or stdout.
struct Outputs {
  std::optional<OutputFile> csv_file;
  std::optional<OutputFile> json_file;
  std::optional<IrradianceCsv> csv;
  std::optional<IrradianceJson> json;

  Outputs(const IrradianceOptions& options, const Scene& scene, const PointTable& table,
          const std::vector<std::string>& lights) {
    if (!options.out.empty()) csv_file.emplace(options.out);
    if (csv_file || options.json != "-") csv.emplace(csv_file ? csv_file->stream() : std::cout, table.header(), lights);
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

ExitCode write_irradiance(const IrradianceOptions& options, const Scene& scene, std::istream& stream,
                          const std::string& file) {
  const std::vector<const SceneLight*> chosen = chosen_lights(scene.lights, options.light);
  const PreparedObstacles obstacles = scene_obstacles(scene);
  LightsOfThreads lights([&] {
    std::vector<LightIrradiance> result;
    for (const SceneLight* light : chosen) result.emplace_back(light->shape, light->strength, obstacles);
    return result;
  });
  std::vector<std::string> names;
  for (const SceneLight* light : chosen) names.push_back(light->name);
  PointTable table(stream, file, TableColumns::points_with_normals);
  Outputs outputs(options, scene, table, names);
  tbb::task_arena threads(arena_size(options.threads));
  if (names.empty()) print_warning("the scene has no light");
  std::size_t points = 0;
  std::size_t malformed_lines = 0;
  for (auto rows = lit_batch(table, lights, threads); !rows.empty(); rows = lit_batch(table, lights, threads)) {
    for (const LitRow& lit : rows) {
      if (outputs.csv) outputs.csv->add(lit);
      if (outputs.json) outputs.json->add(lit);
      const auto* malformed = std::get_if<MalformedRow>(&lit.row);
      ++(malformed ? malformed_lines : points);
      if (malformed) print_error(file + ':' + std::to_string(malformed->line) + ": " + malformed->problem);
    }
    finish_stdout();
  }
  outputs.publish(points, malformed_lines);
  return malformed_lines == 0 ? ExitCode::done : ExitCode::bad_scene;
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
  const Scene scene = read_scene(options.scene);
  if (scene.dimension != 3) {
    throw UnsupportedError(scene.source + ": irradiance in scenes of dimension 2 is not available in this version");
  }
  return with_points(options.at, [&](std::istream& stream, const std::string& file) {
    return write_irradiance(options, scene, stream, file);
  });
}

}  // namespace gnomon
