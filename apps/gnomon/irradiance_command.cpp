#include <algorithm>
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
#include "apps/gnomon/irradiance_output.h"
#include "apps/gnomon/light_groups.h"
#include "apps/gnomon/linear_search_option.h"
#include "apps/gnomon/output_file.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/point_batches.h"
#include "apps/gnomon/receiver_rows.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/sensor_files.h"
#include "apps/gnomon/started_processes.h"
#include "apps/gnomon/text.h"
#include "apps/gnomon/viewed_surface.h"
#include "geometry/bodies/body.h"
#include "geometry/parallel.h"
#include "geometry/shared_work.h"
#include "gnomon/irradiance.h"
#include "gnomon/scene.h"
#include "gnomon/visibility.h"
#include "shading/receiver_grid.h"

namespace gnomon {
namespace {

struct IrradianceOptions : CommonOptions {
  std::string at;
  std::string on;
  std::string shape;
  std::string lift;
  std::string eye;
  std::string material;
  std::string out;
  SensorFileNames files;
  IrradianceLayout layout;
};

void add_options(CommandLine& app, IrradianceOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_text(app, "--at", options.at, "POINTS.csv|-",
           "Receivers as CSV with columns x,y,z,nx,ny,nz, or six numbers a line without a header; '-' reads them from\n"
           "stdin. Commas, semicolons, tabs or blanks separate; further columns are passed through");
  add_text(app, "--on", options.on, "RECEIVER",
           "Points on this receiver of the scene, on each side from which it receives; of a mesh on every facet. They\n"
           "are asked on the facet itself, whatever rounding does to them");
  add_text(
      app, "--shape", options.shape, "nu,nv",
      "With --on: the number of points along a facet's first side and at right angles to it. They are the middles\n"
      "of equal cells of the smallest such rectangle; those beside the facet are left out. Without it one point,\n"
      "the mean of the corners");
  add_text(app, "--lift", options.lift, "H",
           "Move every point by this length along its normal first; rows repeat the point as it was");
  add_text(app, "--eye", options.eye, "x,y,z|camera",
           "Also tell the radiance that each point reflects to an eye here, or to that of the scene's camera");
  add_text(app, "--material", options.material, "NAME",
           "With --eye: what the points are made of, as for gnomon radiance");
  add_text(app, "--out", options.out, "FILE", "Write the CSV to this file (default: to stdout)");
  app.add_flag("--sum", options.layout.sum, "A row for each point, with the sum over all lights");
  app.add_flag("--wide", options.layout.wide,
               "A row for each point, with two columns for each light: irradiance_NAME,error_bound_NAME");
  add_text(app, "--sensors", options.files.sensors, "FILE",
           "Also write the points as daylight tools read them, x y z nx ny nz a line");
  add_text(app, "--values", options.files.values, "FILE",
           "Also write a line for each point, with the irradiance of all lights together alone");
  add_json_option(app, options);
  add_text(app, "--light", options.light, "NAME", "Only this light");
  add_linear_search_option(app, options);
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Each row of the result is a row of the input, or x,y,z,nx,ny,nz of a point on the receiver (and facet, where\n"
      "it has several facets or sides), followed by light,irradiance,error_bound. Irradiance is in W/m^2 whatever the "
      "scene's unit of length, and clipped by the\n"
      "receiver's horizon; |irradiance - exact| is at most error_bound. It is positive exactly where gnomon regions\n"
      "tells lit or penumbra. A facet right under a point, up to rounding, does not hide the light from it. With\n"
      "--out FILE, and in the JSON, mean over the points, least and largest irradiance are told, too; --sensors and "
      "--values have neither bounds nor names. A malformed line "
      "is reported\n"
      "with its number and left out; the exit code is 3 then.\n\n"
      "With --eye the columns radiance and radiance_error_bound follow, in W/(m^2 sr); where colours differ,\n"
      "radiance_r,radiance_error_bound_r and so on. In the row of --sum they count ambient light too, which is no\n"
      "light of its own here.\n\n"
      "Examples:\n"
      "  gnomon irradiance examples/figure_4_22.scene.json --at examples/receivers.csv\n"
      "  gnomon irradiance examples/still_life.scene.json --on floor --eye camera\n");
}

/// What is asked of every point.
struct Question {
  std::vector<LightGroup> groups;
  std::vector<const SceneLight*> chosen;  ///< all their parts
  LengthUnit unit;
  std::vector<std::vector<LightIrradiance>> lights;  ///< of each worker, for it keeps memory for the next question
  std::array<double, 3> eye{};
  const SceneMaterial* material = nullptr;    ///< none without an eye
  std::optional<ViewedSurface> surface = {};  ///< with an eye
};

void light_up(LitRow& lit, const RowSource& receivers, Question& question, std::size_t worker) {
  const auto* row = std::get_if<PointRow>(&lit.row);
  if (!row) return;
  const ReceiverPoint receiver = receivers.receiver_of(*row);
  const auto& [x, y, z] = row->normal;
  std::vector<LightIrradiance>& local = question.lights[worker];
  std::vector<Irradiance> of_parts;
  for (std::size_t l = 0; l < local.size(); ++l) {
    const Irradiance e = local[l].received(receiver, {x, y, z});
    of_parts.push_back(per_square_metre(e, question.chosen[l]->shape, question.unit));
  }
  lit.received = irradiance_of_groups(question.groups, of_parts);
  if (!question.surface) return;
  lit.reflected = question.surface->at(worker, receiver, {x, y, z}, question.eye);
  lit.eye = question.eye;
}

/// The rows of a batch, of which each process works out its own.
std::vector<LitRow> lit_rows(const RowSource& receivers, std::vector<TableRow> batch, Question& question) {
  const Processes& processes = started_processes();
  std::vector<LitRow> rows;
  for (TableRow& row : batch) rows.push_back({std::move(row), {}, {}});
  std::vector<std::vector<char>> packed(rows.size());
  share_results<char>(processes, packed, [&] {
    for_all(rows.size(), static_cast<unsigned>(question.lights.size()), [&](std::size_t i, std::size_t worker) {
      if (!processes.is_mine(i)) return;
      light_up(rows[i], receivers, question, worker);
      if (processes.count > 1) packed[i] = packed_results(rows[i]);
    });
  });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!processes.is_mine(i)) unpack_results(packed[i], rows[i]);
  }
  return rows;
}

/// All that may differ between scenes that were taken for one.
std::vector<Point3> points_of(const SpaceScene& scene, const Obstacles& obstacles) {
  std::vector<Point3> all;
  const auto add = [&](const auto& points) { all.insert(all.end(), points.begin(), points.end()); };
  for (const ConvexBlocker& blocker : obstacles.blockers) {
    std::visit([&](const auto& shape) { add(shape.points()); }, blocker);
  }
  for (const SceneReceiver& receiver : scene.receivers) add(receiver.shape.points());
  for (const SceneLight& light : scene.lights) {
    add(light_points(light.shape));
    all.push_back({light.strength, 0, 0});
  }
  return all;
}

/// Where the results go: any of a CSV file or stdout, and a JSON file or stdout.
struct IrradianceOutputs {
  std::optional<OutputFile> csv_file;
  std::optional<OutputFile> json_file;
  std::optional<IrradianceCsv> csv;
  std::optional<IrradianceJson> json;
  SensorFiles files;

  IrradianceOutputs(const IrradianceOptions& options, const SpaceScene& scene, const std::string& header,
                    const std::vector<std::string>& lights, const Question& question)
      : files(options.files) {
    IrradianceLayout layout = options.layout;
    const SceneMaterial* material = question.material;
    if (material) layout.radiance = RadianceColumns{is_coloured(scene, material->material, question.chosen)};
    if (!options.out.empty()) csv_file.emplace(options.out);
    if (csv_file || options.json != "-") {
      csv.emplace(csv_file ? csv_file->stream() : std::cout, header, lights, layout);
    }
    if (options.json.empty()) return;
    if (options.json != "-") json_file.emplace(options.json);
    json.emplace(json_file ? json_file->stream() : std::cout, scene, lights, layout, material ? material->name : "");
  }

  void add(const LitRow& lit) {
    if (csv) csv->add(lit);
    if (json) json->add(lit);
    files.add(lit);
  }

  void publish(const IrradianceSummaries& summaries, std::size_t malformed_lines) {
    if (json) json->finish(summaries, malformed_lines);
    files.publish();
    if (csv_file) csv_file->publish();
    if (json_file) json_file->publish();
  }
};

Question question_of(const IrradianceOptions& options, const SpaceScene& scene, const PreparedObstacles& obstacles) {
  std::vector<LightGroup> groups = chosen_groups(scene, options.light);
  std::vector<const SceneLight*> chosen = parts_of(groups);
  Question question{std::move(groups), std::move(chosen), *length_unit_named(scene.length_unit),
                    std::vector<std::vector<LightIrradiance>>(thread_count(options.threads))};
  for (std::vector<LightIrradiance>& own : question.lights) {
    for (const SceneLight* light : question.chosen) {
      own.emplace_back(light->shape, light->strength, obstacles, linear_search(options));
    }
  }
  if (options.eye.empty()) return question;
  question.eye = eye_named(options.eye, scene);
  question.material = &chosen_material(options.material, options.on, scene);
  question.surface.emplace(scene, question.groups, question.material->material, obstacles,
                           SurfaceViewers{static_cast<unsigned>(question.lights.size()), linear_search(options)});
  return question;
}

ExitCode write_irradiance(const IrradianceOptions& options, const SpaceScene& scene, const PreparedObstacles& obstacles,
                          const RowSource& receivers) {
  require_same_points(started_processes(), points_of(scene, obstacles.obstacles()));
  Question question = question_of(options, scene, obstacles);
  const std::vector<std::string> names = names_of(question.groups);
  IrradianceOutputs outputs(options, scene, receivers.header, names, question);
  if (names.empty()) print_warning("the scene has no light");
  Progress progress("point", receivers.count, progress_visibility(options.quiet, options.out.empty()));
  IrradianceSummaries summaries(names);
  std::size_t malformed_lines = 0;
  for (auto batch = receivers.next_batch(); !batch.empty(); batch = receivers.next_batch()) {
    const std::size_t count = batch.size();
    for (const LitRow& lit : lit_rows(receivers, std::move(batch), question)) {
      outputs.add(lit);
      const auto* malformed = std::get_if<MalformedRow>(&lit.row);
      summaries.add(lit);
      malformed_lines += malformed ? 1 : 0;
      if (malformed) print_error(receivers.file + ':' + std::to_string(malformed->line) + ": " + malformed->problem);
    }
    if (!outputs.json_file) finish_stdout();
    progress.step(count);
    progress.set_share(receivers.share());
  }
  outputs.publish(summaries, malformed_lines);
  if (!options.quiet && !options.out.empty() && options.json != "-") std::cout << summaries.text();
  return malformed_lines == 0 ? ExitCode::done : ExitCode::bad_scene;
}

/// The length of --lift, 0 without it.
double lift_of(const IrradianceOptions& options) {
  return options.lift.empty() ? 0 : finite_value("--lift", options.lift, "a length, such as 0.01");
}

/// The receiver's point of a row, lifted along its normal.
ReceiverPoint lifted_point(const PreparedObstacles& obstacles, const PointRow& row, double lift) {
  const Point3 p{row.coordinates[0], row.coordinates[1], row.coordinates[2]};
  const Point3 n{row.normal[0], row.normal[1], row.normal[2]};
  return resting_point(obstacles, lift == 0 ? p : moved_along(p, n, lift), n);
}

ExitCode at_points(const IrradianceOptions& options, const SpaceScene& scene) {
  const PreparedObstacles obstacles(scene_bodies(scene).obstacles);
  const double lift = lift_of(options);
  return with_points(options.at, [&](std::istream& stream, const std::string& file) {
    PointTable table(stream, file, TableColumns::points_with_normals);
    const auto receiver_of = [&](const PointRow& row) { return lifted_point(obstacles, row, lift); };
    return write_irradiance(options, scene, obstacles,
                            {file, table.header(), [&] { return next_rows(table); }, receiver_of, 0,
                             [&] { return share_read(stream, options.at); }});
  });
}

ExitCode on_receiver(const IrradianceOptions& options, const SpaceScene& scene) {
  require_receiver("--on", options.on, scene.receivers);
  const PreparedObstacles obstacles(scene_bodies(scene).obstacles);
  std::optional<std::array<std::uint32_t, 2>> shape;
  if (!options.shape.empty()) shape = whole_numbers<2>("--shape", options.shape, "nu,nv");
  ReceiverRows rows(scene, options.on, shape);
  if (!rows.has_finite_points()) {
    throw UnsupportedError(scene.source + ": receiver '" + options.on + "' is wider than doubles go (1.8e308)");
  }
  const double lift = lift_of(options);
  const OwnBlockers own(obstacles.obstacles().blockers);
  const auto receiver_of = [&](const PointRow& row) {
    return lift == 0 ? rows.receiver_of(row, own) : lifted_point(obstacles, row, lift);
  };
  return write_irradiance(options, scene, obstacles,
                          {options.on, rows.header(), [&] { return rows.next(); }, receiver_of, rows.count()});
}

}  // namespace

ExitCode irradiance_command(Arguments arguments) {
  CommandLine app(
      "Tells for receivers, points with normals, the irradiance that each light gives them behind all blockers\n"
      "together, and a bound of its error.",
      "gnomon irradiance");
  IrradianceOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  require_table_places(options.out, options.json, {options.scene, options.at});
  require_sensor_places(options.files, {options.scene, options.at}, {options.out, options.json});
  if (options.out == "-") options.out.clear();
  if (options.at == "-" && started_processes().count > 1) {
    throw UsageError("--at -: of several processes only the first could read it; expected a file");
  }
  if (!is_first_process()) options.out = options.json = options.files.sensors = options.files.values = "";
  if (options.at.empty() == options.on.empty()) throw UsageError("expected either --at POINTS.csv or --on RECEIVER");
  if (options.on.empty() && !options.shape.empty()) throw UsageError("--shape nu,nv goes with --on RECEIVER");
  if (options.eye.empty() && !options.material.empty()) throw UsageError("--material NAME goes with --eye x,y,z");
  const SpaceScene scene = space_scene_with_warnings(options.scene, "irradiance");
  return options.on.empty() ? at_points(options, scene) : on_receiver(options, scene);
}

}  // namespace gnomon
