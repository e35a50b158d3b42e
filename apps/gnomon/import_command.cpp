#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/imported_model.h"
#include "apps/gnomon/imported_scene.h"
#include "apps/gnomon/output_file.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/text.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

struct ImportOptions {
  std::vector<std::string> files;
  std::string out, unit = "m", up, lights, receivers;
  bool merges_coplanar = false;
  bool quiet = false;
};

void add_options(CommandLine& app, ImportOptions& options) {
  app.add_texts(
      "FILE", options.files, "FILE",
      "OBJ files, with the MTL files that they name, glTF (.gltf, .glb), OFF, PLY, STL files or Radiance scenes "
      "(.rad)");
  add_required_text(app, "--out", options.out, "SCENE", "Scene file to write, in the folder of meshes or above it");
  add_text(app, "--unit", options.unit, "UNIT", "What a length of 1 is: m (default), mm, cm, km, in or ft");
  add_text(app, "--up", options.up, "AXIS", "The axis that points up: z or y (default: y for glTF, else z)");
  add_text(app, "--light", options.lights, "MATERIAL=RADIANCE,...",
           "Facets of these materials are lights of so many W/(m^2 sr); those that emit are lights anyway");
  add_text(app, "--receiver", options.receivers, "MATERIAL,...", "Facets of these materials are receivers, too");
  app.add_flag("--merge-coplanar", options.merges_coplanar,
               "Join facets of lamps that make a convex polygon exactly to one light");
  app.add_flag("--quiet", options.quiet, "No summary; warnings and errors only");
  app.footer(
      "The scene names mesh files and leaves them as they are: of each material there is one blocker, a mesh with\n"
      "\"usemtl\"; triangles of glTF and polygons of Radiance scenes are copied. Facets of materials that emit (Ke,\n"
      "emissiveFactor, light, glow, illum) are polygon lights, not blockers: the largest channel is the radiance,\n"
      "the color the rest. What else materials tell is for 'gnomon radiance' and 'image'. Facets without a\n"
      "material are called as their file. What is passed over is told, one line a kind.\n\n"
      "Examples:\n"
      "  gnomon import examples/lit_chair.obj --out chair.scene.json\n"
      "  gnomon import examples/lit_chair.obj --out c.scene.json --receiver floor\n");
}

/// The list's items, each a material of a model, before their '=' if they have values.
std::map<std::string, std::string> chosen_materials(const std::string& option, const std::string& text, bool has_values,
                                                    const std::vector<ImportedModel>& models) {
  std::map<std::string, std::string> chosen;
  if (text.empty()) return chosen;
  std::vector<std::string_view> titles;
  for (const ImportedModel& model : models) {
    for (std::size_t m = 0; m < model.soup.materials.size(); ++m) titles.push_back(model.material_title(m));
  }
  for (const std::string_view item : comma_separated(text)) {
    const std::size_t equals = has_values ? item.rfind('=') : std::string_view::npos;
    const std::string name(item.substr(0, equals));
    if (has_values && equals == std::string_view::npos) {
      throw UsageError(option + ": found '" + std::string(item) + "'; expected MATERIAL=RADIANCE");
    }
    if (std::ranges::find(titles, name) == titles.end()) {
      throw UsageError(option + ": no facet has the material '" + name + "'" + nearest_text(name, titles));
    }
    chosen[name] = has_values ? std::string(item.substr(equals + 1)) : "";
  }
  return chosen;
}

ImportChoice import_choice(const ImportOptions& options, const std::vector<ImportedModel>& models) {
  const bool is_y_up = options.up.empty() ? std::ranges::any_of(models, &ImportedModel::is_y_up) : options.up == "y";
  ImportChoice choice{options.unit, is_y_up ? "y" : "z", {}, {}, options.merges_coplanar};
  for (const auto& [name, value] : chosen_materials("--light", options.lights, true, models)) {
    const double radiance = finite_value("--light", value, "MATERIAL=RADIANCE, the radiance a number above 0");
    if (!(radiance > 0)) throw UsageError("--light: found the radiance " + value + "; expected a number above 0");
    choice.lights[name] = radiance;
  }
  for (const auto& [name, value] : chosen_materials("--receiver", options.receivers, false, models)) {
    choice.receivers.insert(name);
  }
  return choice;
}

/// How a scene in one folder calls a file in it or below it.
std::string name_beside(const std::filesystem::path& file, const std::filesystem::path& scene) {
  const auto folder = std::filesystem::absolute(scene).lexically_normal().parent_path();
  const auto name = std::filesystem::absolute(file).lexically_normal().lexically_relative(folder);
  if (name.empty() || *name.begin() == "..") {
    throw UsageError("--out: a scene names files in its folder or below it; " + file.string() + " is not below " +
                     (scene.has_parent_path() ? scene.parent_path().string() : "."));
  }
  return name.generic_string();
}

/// How the scene calls a model's file.
std::string mesh_file(const ImportedModel& model, const std::string& file, const std::string& out) {
  if (model.form != ModelForm::mesh_file) return {};
  return out == "-" ? std::filesystem::path(file).filename().string() : name_beside(file, out);
}

void require_choices(const ImportOptions& options) {
  if (!length_unit_named(options.unit)) {
    throw UsageError("--unit: found '" + options.unit + "'; expected m, mm, cm, km, in or ft");
  }
  if (!options.up.empty() && options.up != "y" && options.up != "z")
    throw UsageError("--up: found '" + options.up + "'; expected y or z");
  require_place("--out", options.out, OutputKind::json);
  require_unread("--out", options.out, options.files);
}

std::string summary(const ImportedScene& scene, const std::string& out) {
  std::string text = out + ": " + counted(scene.lights, "light") + ", " + counted(scene.blockers, "blocker") + ", " +
                     counted(scene.receivers, "receiver");
  if (scene.joined > 0) {
    text += "; " + counted(scene.joined, "facet") + " of lamps joined to " + counted(scene.joined_to, "light");
  }
  return labelled("written", text);
}

}  // namespace

ExitCode import_command(Arguments arguments) {
  CommandLine app("Makes a scene of models with their materials: lamps are lights, all else blocks.", "gnomon import");
  ImportOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  require_choices(options);
  std::vector<ImportedModel> models;
  std::vector<std::string> mesh_files;
  for (const std::string& file : options.files) {
    models.push_back(imported_model(file, options.unit));
    mesh_files.push_back(mesh_file(models.back(), file, options.out));
  }
  const ImportedScene scene = imported_scene(models, mesh_files, import_choice(options, models));
  if (options.out == "-") {
    std::cout << scene.text;
    return ExitCode::done;
  }
  // What the scene reader would refuse is refused here, before anything is written.
  parse_scene(scene.text, options.out, std::filesystem::absolute(options.out).parent_path());
  write_output_file(options.out, scene.text);
  if (!options.quiet) std::cout << summary(scene, options.out);
  return ExitCode::done;
}

}  // namespace gnomon
