#include <algorithm>
#include <array>
#include <cmath>
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
#include "apps/gnomon/output_file.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/point_batches.h"
#include "apps/gnomon/radiance_output.h"
#include "apps/gnomon/scene_input.h"
#include "geometry/parallel.h"
#include "gnomon/reflection.h"
#include "gnomon/scene.h"
#include "gnomon/visibility.h"

namespace gnomon {
namespace {

struct RadianceOptions : CommonOptions {
  std::string at;
  std::string material;
  std::string out;
};

void add_options(CommandLine& app, RadianceOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_text(app, "--at", options.at, "VIEWS.csv|-",
           "Views as CSV with columns x,y,z,nx,ny,nz,ex,ey,ez: a point, its normal, and where the eye is; or nine\n"
           "numbers a line without a header. '-' reads them from stdin. Further columns are passed through");
  add_text(app, "--material", options.material, "NAME",
           "What the points are made of: one of the scene's materials. Without it the only one, or, in a scene\n"
           "without materials, a diffuse grey of 0.5");
  add_text(app, "--out", options.out, "FILE", "Write the CSV to this file (default: to stdout)");
  add_json_option(app, options);
  add_text(app, "--light", options.light, "NAME", "Only this light");
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Each row of the result is a row of the input, followed by light,radiance,error_bound: one for each light,\n"
      "one for ambient light and one for their total; where colours differ, radiance_r,error_bound_r and so on.\n"
      "Radiance is in W/(m^2 sr) whatever the scene's unit of length; |radiance - exact| is at most error_bound,\n"
      "for the direction to the eye as the difference of the two points rounded to doubles. Where the eye is not\n"
      "above the point's plane it is 0. A malformed line is reported with its number and left out; the exit code\n"
      "is 3 then.\n\n"
      "Examples:\n"
      "  gnomon radiance examples/two_lamps.scene.json --at examples/views.csv\n"
      "  gnomon radiance examples/two_lamps.scene.json --at examples/views.csv --json -\n");
}

/// The material that was asked for.
const SceneMaterial& chosen_material(const RadianceOptions& options, const SpaceScene& scene) {
  static const SceneMaterial grey{"", {}};
  if (options.material.empty()) {
    if (scene.materials.size() > 1) throw UsageError("the scene has several materials: name one with --material NAME");
    return scene.materials.empty() ? grey : scene.materials.front();
  }
  const auto found = std::ranges::find(scene.materials, options.material, &SceneMaterial::name);
  if (found != scene.materials.end()) return *found;
  std::string known;
  for (const SceneMaterial& material : scene.materials) known += (known.empty() ? "" : ", ") + material.name;
  throw UsageError("--material: found '" + options.material + "', expected a material of the scene" +
                   (known.empty() ? ", which has none" : ": " + known));
}

bool is_grey(const Rgb& colour) {
  return colour[0] == colour[1] && colour[1] == colour[2];
}

RadianceRgb ambient_radiance(const Material& material, const Rgb& ambient) {
  RadianceRgb result;
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = material.ambient[k] * ambient[k];
    result[k] = {value, value == 0 ? 0 : std::fmax(value * 0x1p-52, 0x1p-1074)};
  }
  return result;
}

/// What is the same for all rows.
struct Question {
  std::vector<const SceneLight*> lights;
  Material material;
  LengthUnit unit;
  RadianceRgb ambient;

  RadianceRgb of(const SceneLight& light, Reflection reflection) const {
    reflection.received = per_square_metre(reflection.received, light.shape, unit);
    reflection.lobe = per_square_metre(reflection.lobe, light.shape, unit);
    Rgb strength = light.color;
    for (double& s : strength) s *= light.strength;
    RadianceRgb result = reflected_radiance(reflection, material, strength);
    // What the product of strength and colour rounds.
    if (light.color != Rgb{1, 1, 1}) {
      for (Radiance& r : result) r.error_bound += 0x1p-52 * r.value;
    }
    return result;
  }
};

/// Half of the way from a point to another, which does not overflow.
Point3 halfway(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  return {to[0] / 2 - from[0] / 2, to[1] / 2 - from[1] / 2, to[2] / 2 - from[2] / 2};
}

/// Of every worker, for every light asked for.
using ReflectionsOfWorkers = std::vector<std::vector<LightReflection>>;

void answer(SeenRow& seen, const Question& question, const PreparedObstacles& obstacles,
            std::vector<LightReflection>& lights) {
  const auto* row = std::get_if<PointRow>(&seen.row);
  if (!row) return;
  const auto& [x, y, z] = row->coordinates;
  const auto& [nx, ny, nz] = row->normal;
  const View view{{x, y, z}, {nx, ny, nz}, halfway(row->coordinates, row->eye)};
  const ReceiverPoint receiver = resting_point(obstacles, view.point, view.normal);
  for (std::size_t l = 0; l < lights.size(); ++l) {
    const Reflection r = lights[l].received(receiver, view, question.material.model, question.material.exponent);
    seen.lights.push_back(question.of(*question.lights[l], r));
  }
  if (eye_is_above(view)) seen.ambient = question.ambient;
}

/// Where the results go.
struct RadianceOutputs {
  std::optional<OutputFile> csv_file, json_file;
  std::optional<RadianceCsv> csv;
  std::optional<RadianceJson> json;

  RadianceOutputs(const RadianceOptions& options, const SpaceScene& scene, const std::string& header,
                  const SceneMaterial& material, const std::vector<const SceneLight*>& lights) {
    std::vector<std::string> names;
    bool coloured = !is_grey(material.material.diffuse) || !is_grey(material.material.specular) ||
                    !is_grey(material.material.ambient) || !is_grey(scene.ambient_radiance);
    for (const SceneLight* light : lights) {
      names.push_back(light->name);
      coloured |= !is_grey(light->color);
    }
    if (!options.out.empty()) csv_file.emplace(options.out);
    if (csv_file || options.json != "-") {
      csv.emplace(csv_file ? csv_file->stream() : std::cout, header, names, coloured);
    }
    if (options.json.empty()) return;
    if (options.json != "-") json_file.emplace(options.json);
    json.emplace(json_file ? json_file->stream() : std::cout, scene, material.name, names);
  }
  void add(const SeenRow& seen) {
    if (csv) csv->add(seen);
    if (json) json->add(seen);
  }
  void publish(std::size_t points, std::size_t malformed_lines) {
    if (json) json->finish(points, malformed_lines);
    if (csv_file) csv_file->publish();
    if (json_file) json_file->publish();
  }
};

ExitCode write_radiance(const RadianceOptions& options, const SpaceScene& scene, PointTable& table,
                        const std::string& file, const std::function<double()>& share) {
  const PreparedObstacles obstacles(scene_bodies(scene).obstacles);
  const SceneMaterial& material = chosen_material(options, scene);
  const Question question{chosen_lights(scene.lights, options.light), material.material,
                          *length_unit_named(scene.length_unit),
                          ambient_radiance(material.material, scene.ambient_radiance)};
  ReflectionsOfWorkers reflections(thread_count(options.threads));
  for (std::vector<LightReflection>& own : reflections) {
    for (const SceneLight* light : question.lights) own.emplace_back(light->shape, obstacles);
  }
  RadianceOutputs outputs(options, scene, table.header(), material, question.lights);
  Progress progress("point", 0, progress_visibility(options.quiet, options.out.empty()));
  std::size_t points = 0, malformed_lines = 0;
  for (auto batch = next_rows(table); !batch.empty(); batch = next_rows(table)) {
    std::vector<SeenRow> rows;
    for (TableRow& row : batch) rows.push_back({std::move(row), {}, {}});
    for_all(rows.size(), static_cast<unsigned>(reflections.size()),
            [&](std::size_t i, std::size_t worker) { answer(rows[i], question, obstacles, reflections[worker]); });
    for (const SeenRow& seen : rows) {
      outputs.add(seen);
      const auto* malformed = std::get_if<MalformedRow>(&seen.row);
      ++(malformed ? malformed_lines : points);
      if (malformed) print_error(file + ':' + std::to_string(malformed->line) + ": " + malformed->problem);
    }
    if (!outputs.json_file) finish_stdout();
    progress.step(rows.size());
    progress.set_share(share());
  }
  outputs.publish(points, malformed_lines);
  return malformed_lines == 0 ? ExitCode::done : ExitCode::bad_scene;
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
  require_table_places(options.out, options.json);
  if (options.out == "-") options.out.clear();
  if (options.at.empty()) throw UsageError("expected --at VIEWS.csv");
  const SpaceScene scene = space_scene_with_warnings(options.scene, "radiance");
  return with_points(options.at, [&](std::istream& stream, const std::string& file) {
    PointTable table(stream, file, TableColumns::views);
    return write_radiance(options, scene, table, file, [&] { return share_read(stream, options.at); });
  });
}

}  // namespace gnomon
