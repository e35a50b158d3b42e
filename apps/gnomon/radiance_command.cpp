#include <array>
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
#include "apps/gnomon/light_groups.h"
#include "apps/gnomon/linear_search_option.h"
#include "apps/gnomon/output_file.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/point_batches.h"
#include "apps/gnomon/radiance_output.h"
#include "apps/gnomon/receiver_rows.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/viewed_surface.h"
#include "geometry/parallel.h"
#include "gnomon/reflection.h"
#include "gnomon/scene.h"
#include "gnomon/visibility.h"

namespace gnomon {
namespace {

struct RadianceOptions : CommonOptions {
  std::string at;
  std::string on;
  std::string shape;
  std::string eye;
  std::string material;
  std::string out;
};

void add_options(CommandLine& app, RadianceOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_text(app, "--at", options.at, "VIEWS.csv|-",
           "Views as CSV with columns x,y,z,nx,ny,nz,ex,ey,ez: a point, its normal, and where the eye is; or nine\n"
           "numbers a line without a header. '-' reads them from stdin. Further columns are passed through");
  add_text(app, "--on", options.on, "RECEIVER",
           "Instead of --at: points on this receiver of the scene, one of its sides or facets, seen from --eye");
  add_text(app, "--shape", options.shape, "nu,nv",
           "With --on: a grid of this many points on each facet; without it one point, the mean of the corners");
  add_text(app, "--eye", options.eye, "x,y,z", "With --on: where the eye is (default: that of the scene's camera)");
  add_text(app, "--material", options.material, "NAME",
           "What the points are made of: one of the scene's materials. Without it the receiver's; or the only one,\n"
           "or, in a scene without materials, a diffuse grey of 0.5");
  add_text(app, "--out", options.out, "FILE", "Write the CSV to this file (default: to stdout)");
  add_json_option(app, options);
  add_text(app, "--light", options.light, "NAME", "Only this light");
  add_linear_search_option(app, options);
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Each row of the result is a row of the input, or x,y,z,nx,ny,nz of a point on the receiver, followed by\n"
      "light,radiance,error_bound: one for each light, one for ambient light and one for their total; where colours "
      "differ, radiance_r,error_bound_r and so on.\n"
      "Radiance is in W/(m^2 sr) whatever the scene's unit of length; |radiance - exact| is at most error_bound,\n"
      "for the direction to the eye as the difference of the two points rounded to doubles. Where the eye is not\n"
      "above the point's plane it is 0. A malformed line is reported with its number and left out; the exit code\n"
      "is 3 then.\n\n"
      "Examples:\n"
      "  gnomon radiance examples/two_lamps.scene.json --at examples/views.csv\n"
      "  gnomon radiance examples/still_life.scene.json --on floor --shape 4,3\n");
}

/// Where the results go.
struct RadianceOutputs {
  std::optional<OutputFile> csv_file, json_file;
  std::optional<RadianceCsv> csv;
  std::optional<RadianceJson> json;

  RadianceOutputs(const RadianceOptions& options, const SpaceScene& scene, const std::string& header,
                  const SceneMaterial& material, const std::vector<LightGroup>& lights) {
    const std::vector<std::string> names = names_of(lights);
    const bool coloured = is_coloured(scene, material.material, parts_of(lights));
    if (!options.out.empty()) csv_file.emplace(options.out);
    if (csv_file || options.json != "-") {
      csv.emplace(csv_file ? csv_file->stream() : std::cout, header, names, coloured);
    }
    if (options.json.empty()) return;
    if (options.json != "-") json_file.emplace(options.json);
    json.emplace(json_file ? json_file->stream() : std::cout, scene, material.name, names);
  }
  void add(const ViewedRow& seen) {
    if (csv) csv->add(seen);
    if (json) json->add(seen);
  }
  void publish(std::size_t points, std::size_t malformed_lines) {
    if (json) json->finish(points, malformed_lines);
    if (csv_file) csv_file->publish();
    if (json_file) json_file->publish();
  }
};

ExitCode write_radiance(const RadianceOptions& options, const SpaceScene& scene, const PreparedObstacles& obstacles,
                        const RowSource& views) {
  const SceneMaterial& material = chosen_material(options.material, options.on, scene);
  const std::vector<LightGroup> lights = chosen_groups(scene, options.light);
  const unsigned threads = thread_count(options.threads);
  ViewedSurface surface(scene, lights, material.material, obstacles, {threads, linear_search(options)});
  RadianceOutputs outputs(options, scene, views.header, material, lights);
  Progress progress("point", views.count, progress_visibility(options.quiet, options.out.empty()));
  std::size_t points = 0, malformed_lines = 0;
  for (auto batch = views.next_batch(); !batch.empty(); batch = views.next_batch()) {
    std::vector<ViewedRow> rows;
    for (TableRow& row : batch) rows.push_back({std::move(row), {}});
    for_all(rows.size(), threads, [&](std::size_t i, std::size_t worker) {
      const auto* row = std::get_if<PointRow>(&rows[i].row);
      if (!row) return;
      const auto& [x, y, z] = row->normal;
      rows[i].reflected = surface.at(worker, views.receiver_of(*row), {x, y, z}, row->eye);
    });
    for (const ViewedRow& seen : rows) {
      outputs.add(seen);
      const auto* malformed = std::get_if<MalformedRow>(&seen.row);
      ++(malformed ? malformed_lines : points);
      if (malformed) print_error(views.file + ':' + std::to_string(malformed->line) + ": " + malformed->problem);
    }
    if (!outputs.json_file) finish_stdout();
    progress.step(rows.size());
    progress.set_share(views.share());
  }
  outputs.publish(points, malformed_lines);
  return malformed_lines == 0 ? ExitCode::done : ExitCode::bad_scene;
}

ExitCode at_views(const RadianceOptions& options, const SpaceScene& scene) {
  const PreparedObstacles obstacles(scene_bodies(scene).obstacles);
  return with_points(options.at, [&](std::istream& stream, const std::string& file) {
    PointTable table(stream, file, TableColumns::views);
    const auto receiver_of = [&](const PointRow& row) {
      const auto& [x, y, z] = row.coordinates;
      const auto& [nx, ny, nz] = row.normal;
      return resting_point(obstacles, {x, y, z}, {nx, ny, nz});
    };
    return write_radiance(options, scene, obstacles,
                          {file, table.header(), [&] { return next_rows(table); }, receiver_of, 0,
                           [&] { return share_read(stream, options.at); }});
  });
}

ExitCode on_receiver_seen(const RadianceOptions& options, const SpaceScene& scene) {
  require_receiver("--on", options.on, scene.receivers);
  if (options.eye.empty() && !scene.camera) {
    throw UsageError("--on RECEIVER: expected --eye x,y,z, as the scene has no camera");
  }
  const std::array<double, 3> eye = eye_named(options.eye.empty() ? "camera" : options.eye, scene);
  const PreparedObstacles obstacles(scene_bodies(scene).obstacles);
  std::optional<std::array<std::uint32_t, 2>> shape;
  if (!options.shape.empty()) shape = whole_numbers<2>("--shape", options.shape, "nu,nv");
  ReceiverRows rows(scene, options.on, shape);
  if (!rows.has_finite_points()) {
    throw UnsupportedError(scene.source + ": receiver '" + options.on + "' is wider than doubles go (1.8e308)");
  }
  const OwnBlockers own(obstacles.obstacles().blockers);
  const auto next_batch = [&] {
    std::vector<TableRow> batch = rows.next();
    for (TableRow& row : batch) std::get<PointRow>(row).eye = eye;
    return batch;
  };
  const auto receiver_of = [&](const PointRow& row) { return rows.receiver_of(row, own); };
  return write_radiance(options, scene, obstacles, {options.on, rows.header(), next_batch, receiver_of, rows.count()});
}

}  // namespace

ExitCode radiance_command(Arguments arguments) {
  CommandLine app(
      "Tells for points of surfaces the radiance that they reflect of each light, behind all blockers together,\n"
      "to an eye, and a bound of its error.",
      "gnomon radiance");
  RadianceOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  require_table_places(options.out, options.json, {options.scene, options.at});
  if (options.out == "-") options.out.clear();
  if (options.at.empty() == options.on.empty()) throw UsageError("expected either --at VIEWS.csv or --on RECEIVER");
  if (options.on.empty() && !options.shape.empty()) throw UsageError("--shape nu,nv goes with --on RECEIVER");
  if (options.on.empty() && !options.eye.empty()) throw UsageError("--eye x,y,z goes with --on RECEIVER");
  const SpaceScene scene = space_scene_with_warnings(options.scene, "radiance");
  return options.on.empty() ? at_views(options, scene) : on_receiver_seen(options, scene);
}

}  // namespace gnomon
