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
#include "apps/gnomon/console.h"
#include "apps/gnomon/discontinuity_output.h"
#include "apps/gnomon/illumination_output.h"
#include "apps/gnomon/light_groups.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/receiver_rows.h"
#include "apps/gnomon/scene_input.h"
#include "apps/gnomon/started_processes.h"
#include "apps/gnomon/text.h"
#include "apps/gnomon/view_surfaces.h"
#include "geometry/parallel.h"
#include "geometry/scene/receiver_facets.h"
#include "geometry/scene/scene_points.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon {
namespace {

struct IlluminateOptions : CommonOptions {
  std::string out;
  std::string receiver;
  std::string format = "vtm";
  std::string tolerance;
  std::string relative;
  std::string split = "need";
  std::uint32_t order = 1;
  std::uint32_t most_faces = 1000000;
  bool faces = false;
};

void add_options(CommandLine& app, IlluminateOptions& options) {
  add_required_text(app, "SCENE", options.scene, "FILE", "Scene file");
  add_text(app, "--out", options.out, "DIR", "Folder for the files; without it meshes are only told of");
  add_json_option(app, options);
  add_text(app, "--tolerance", options.tolerance, "T", "How far off interpolated irradiance may be, in W/m^2");
  add_text(app, "--relative", options.relative, "R",
           "The same as a share of the largest irradiance there is (default: 0.01)");
  app.add_number("--order", options.order, "1|2", 1, 2, "Linear faces or quadratic ones (default: 1)");
  add_text(app, "--split", options.split, "need|all|none",
           "Which discontinuities of order 2 faces are cut along: those of receivers where that takes fewer faces\n"
           "(default), all or none; those of order 0 and 1 always are");
  app.add_flag("--faces", options.faces, "Mesh the facets of the blockers from outside, too");
  add_text(app, "--receiver", options.receiver, "NAME", "Only this receiver");
  add_text(app, "--light", options.light, "NAME", "Only this light");
  app.add_number("--max-faces", options.most_faces, "N", 1, 100000000,
                 "Stop dividing a receiver at about so many faces (default: 1000000)");
  add_text(app, "--box", options.box, "xmin,ymin,zmin,xmax,ymax,zmax", "The box that is written as clip_box");
  add_text(app, "--format", options.format, "LIST", "One or both of vtm,vtpc (default: vtm)");
  add_threads_option(app, options);
  add_quiet_option(app, options);
  app.footer(
      "Each receiver is cut where irradiance jumps or bends, and its faces are halved until what is interpolated\n"
      "between their points is within the tolerance of the irradiance of all lights together. Points have\n"
      "irradiance with a proven bound; the errors of faces are estimates, from 25 places and more in each. Faces\n"
      "that do not get within the tolerance are written and counted as unmet.\n\n"
      "Examples:\n"
      "  gnomon illuminate examples/boxes.scene.json --out boxes\n"
      "  gnomon illuminate examples/cornell_box.scene.json --relative 0.05 --json -\n");
}

/// Throws: UsageError.
double positive(const std::string& option, const std::string& text) {
  const double value = finite_value(option, text, "a number larger than 0");
  if (!(value > 0)) throw UsageError(option + ": found '" + text + "', expected a number larger than 0");
  return value;
}

IlluminationEffort effort_of(const IlluminateOptions& options) {
  IlluminationEffort effort;
  if (!options.tolerance.empty() && !options.relative.empty()) {
    throw UsageError("--tolerance and --relative say the same in two ways: expected one of them");
  }
  effort.is_relative = options.tolerance.empty();
  if (!options.tolerance.empty()) effort.tolerance = positive("--tolerance", options.tolerance);
  if (!options.relative.empty()) effort.tolerance = positive("--relative", options.relative);
  effort.order = static_cast<int>(options.order);
  effort.most_faces = options.most_faces;
  constexpr std::pair<std::string_view, IlluminationSplit> splits[] = {
      {"need", IlluminationSplit::need}, {"all", IlluminationSplit::all}, {"none", IlluminationSplit::none}};
  const auto split = std::ranges::find(splits, options.split, &std::pair<std::string_view, IlluminationSplit>::first);
  if (split == std::end(splits)) {
    throw UsageError("--split: found '" + options.split + "', expected need, all or none");
  }
  effort.split = split->second;
  effort.threads = thread_count(options.threads);
  effort.processes = started_processes();
  return effort;
}

/// What is meshed: flat pieces, and of which side each is one.
struct Subjects {
  std::vector<ConvexPolygon> pieces;
  std::vector<std::string> sides;
  std::vector<std::size_t> side_of;
  std::vector<std::optional<Rgb>> diffuse;  ///< of each side

  void add(const std::string& name, const ViewSurface& shape, const std::optional<Rgb>& reflected) {
    for (const ConvexPolygon& piece : shape) {
      pieces.push_back(piece);
      side_of.push_back(sides.size());
    }
    sides.push_back(name);
    diffuse.push_back(reflected);
  }
};

std::optional<Rgb> diffuse_of(const SpaceScene& scene, const std::string& material) {
  const auto found = std::ranges::find(scene.materials, material, &SceneMaterial::name);
  return found == scene.materials.end() ? std::nullopt : std::optional(found->material.diffuse);
}

Subjects subjects_of(const SpaceScene& scene, const SceneBodies& bodies, const IlluminateOptions& options) {
  require_receiver("--receiver", options.receiver, scene.receivers);
  Subjects subjects;
  for (const ReceiverGroup side : receiver_sides(scene.receivers)) {
    ViewSurface shape;
    for (const SceneReceiver& facet : side) {
      if (options.receiver.empty() || facet.is_called(options.receiver)) shape.push_back(facet.shape);
    }
    if (!shape.empty()) subjects.add(side.front().side, shape, diffuse_of(scene, side.front().material));
  }
  if (!options.faces) return subjects;
  for (std::size_t b = 0; b < bodies.names.size(); ++b) {
    const SceneBodies one{{{bodies.obstacles.blockers[b]}, {}}, {bodies.names[b]}, {bodies.blocker_ids[b]}};
    const ViewSurfaces faces = blocker_surfaces(scene, one);
    const auto diffuse = diffuse_of(scene, scene.blockers[bodies.blocker_ids[b]].material);
    for (std::size_t s = 0; s < faces.names.size(); ++s) subjects.add(faces.names[s], faces.shapes[s], diffuse);
  }
  return subjects;
}

/// Throws: UnsupportedError for what receivers are not divided by.
void require_support(const SpaceScene& scene, const SceneBodies& bodies, const Subjects& subjects,
                     std::span<const LightGroup> groups) {
  const auto require = [&](std::string_view refusal, const std::string& what) {
    if (!refusal.empty()) throw UnsupportedError(scene.source + ": " + what + ' ' + std::string(refusal));
  };
  for (const LightGroup& group : groups) {
    for (const SceneLight* part : group.parts) {
      require(range_refusal(part->shape), "light '" + group.name + "'");
      const std::string_view refusal = division_refusal(part->shape, bodies.obstacles.enclosures);
      if (!refusal.empty())
        throw UnsupportedError(scene.source + ": light '" + group.name + "': " + std::string(refusal));
    }
  }
  for (const SceneBlocker& blocker : scene.blockers) {
    require(range_refusal(blocker_points(blocker.shape)), "blocker '" + blocker.name + "'");
  }
  for (std::size_t k = 0; k < subjects.pieces.size(); ++k) {
    require(range_refusal(subjects.pieces[k].points()), "receiver '" + subjects.sides[subjects.side_of[k]] + "'");
  }
}

IlluminationResult result_of(const Scene& scene, const Subjects& subjects, std::span<const LightGroup> groups,
                             const Illumination& found, int order) {
  IlluminationResult result{&scene, {}, names_of(groups), {}, found.tolerance, order};
  for (std::size_t s = 0; s < subjects.sides.size(); ++s) {
    result.sides.push_back({subjects.sides[s], {}, subjects.diffuse[s]});
  }
  for (std::size_t k = 0; k < subjects.pieces.size(); ++k) {
    result.sides[subjects.side_of[k]].pieces.push_back(&found.meshes[k]);
  }
  return result;
}

void warn_of_unmet(const Illumination& found) {
  std::size_t unmet = 0;
  for (const IlluminationMesh& mesh : found.meshes) unmet += mesh.unmet_faces();
  if (unmet == 0) return;
  print_warning(counted(unmet, "face") + " did not get within the tolerance of " + rounded_text(found.tolerance) +
                " W/m^2; they are written as unmet");
}

ExitCode write_all(const IlluminateOptions& options, const Scene& scene, IlluminationEffort effort) {
  const auto* space = std::get_if<SpaceScene>(&scene);
  if (!space) throw UnsupportedError(facts(scene).source + ": illumination meshes need a scene of dimension 3");
  const std::vector<LightGroup> groups = chosen_groups(*space, options.light);
  const SceneBodies bodies = scene_bodies(*space);
  const Subjects subjects = subjects_of(*space, bodies, options);
  require_support(*space, bodies, subjects, groups);
  if (groups.empty() || subjects.pieces.empty()) print_warning("the scene has no pair of a light and a receiver");
  std::vector<IlluminationLight> lights;
  for (const LightGroup& group : groups) lights.push_back({shapes_of(group), group.parts.front()->strength});
  effort.unit = *length_unit_named(space->length_unit);
  Progress progress("face", 0, progress_visibility(options.quiet, false));
  effort.progress = [&](std::size_t done, std::size_t of, std::size_t faces) {
    progress.set_done(faces);
    if (of > 1) progress.set_share(static_cast<double>(done) / static_cast<double>(of));
  };
  const Illumination found = illuminate(lights, bodies.obstacles, subjects.pieces, effort);
  if (!is_first_process()) return ExitCode::done;
  IlluminationResult result = result_of(scene, subjects, groups, found, effort.order);
  std::vector<std::filesystem::path> files;
  if (!options.out.empty()) {
    result.clip_box = clip_box(scene, options.box);
    files = write_illumination(result, options.out, tree_formats(options.format));
    warn_of_outdated_results(options.out);
  }
  if (!options.json.empty()) write_json(illumination_json(result, found), options.json);
  warn_of_unmet(found);
  if (!options.quiet && options.json != "-") {
    std::cout << illumination_summary(result, found) << written_files_text(options.out, files);
  }
  return ExitCode::done;
}

}  // namespace

ExitCode illuminate_command(Arguments arguments) {
  CommandLine app(
      "Meshes receivers so that the irradiance interpolated between the points of a mesh is within a tolerance of\n"
      "the exact one everywhere on them.",
      "gnomon illuminate");
  IlluminateOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  tree_formats(options.format);
  require_result_places(options.out, options.json, {options.scene});
  const IlluminationEffort effort = effort_of(options);
  return write_all(options, scene_file_with_warnings(options.scene), effort);
}

}  // namespace gnomon
