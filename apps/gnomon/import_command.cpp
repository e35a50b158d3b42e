#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "apps/gnomon/command_line.h"
#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/output_file.h"
#include "apps/gnomon/output_place.h"
#include "apps/gnomon/text.h"
#include "geometry/scene/file_text.h"
#include "geometry/scene/material_file.h"
#include "geometry/scene/mesh_facets.h"
#include "geometry/scene/mesh_formats.h"
#include "geometry/scene/mesh_text.h"
#include "gnomon/errors.h"
#include "gnomon/point.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t largest_imported_file = std::size_t{128} << 20;

struct ImportOptions {
  std::string file, out, unit = "m", up = "z", lights, receivers;
  bool quiet = false;
};

void add_options(CommandLine& app, ImportOptions& options) {
  add_required_text(app, "FILE", options.file, "FILE", "OBJ file, with the MTL files that it names");
  add_required_text(app, "--out", options.out, "SCENE", "Scene file to write, in the folder of FILE or above it");
  add_text(app, "--unit", options.unit, "UNIT", "What a length of 1 is: m (default), mm, cm, km, in or ft");
  add_text(app, "--up", options.up, "AXIS", "The axis that points up: z (default) or y");
  add_text(app, "--light", options.lights, "MATERIAL=RADIANCE,...",
           "Facets of these materials are lights of so many W/(m^2 sr); those with Ke are lights anyway");
  add_text(app, "--receiver", options.receivers, "MATERIAL,...", "Facets of these materials are receivers, too");
  app.add_flag("--quiet", options.quiet, "No summary; warnings and errors only");
  app.footer(
      "The scene names the OBJ file and leaves it as it is: of each material there is one blocker, a mesh with\n"
      "\"usemtl\". Facets of materials with Ke are polygon lights, not blockers: their radiance is the largest\n"
      "channel of Ke, their color the rest. Kd, Ks and Ns become materials, for 'gnomon radiance' and 'image'.\n"
      "What is passed over is told, one line a kind.\n\n"
      "Examples:\n"
      "  gnomon import examples/lit_chair.obj --out chair.scene.json\n"
      "  gnomon import examples/lit_chair.obj --out c.scene.json --receiver floor\n");
}

/// A model as its files have it.
struct ImportedModel {
  PolygonSoup soup;
  CheckedFacets checked;
  std::map<std::string, FileMaterial> materials;
};

/// Files whose materials are found beside the model; what is missing or not used is told.
std::map<std::string, FileMaterial> materials_of(const PolygonSoup& soup, const std::filesystem::path& folder) {
  std::map<std::string, FileMaterial> all;
  for (std::size_t k = 0; k < soup.material_files.size(); ++k) {
    const std::string& name = soup.material_files[k];
    if (name == "mtllib") continue;
    const FileText text = file_text(folder / name, largest_imported_file, FileKind::regular);
    if (!text.problem.empty()) {
      print_warning((folder / name).string() + ": found " + text.problem + "; its materials are not known");
      continue;
    }
    MaterialFile file = material_file(text.text);
    for (const auto& [word, count] : file.passed_over) {
      print_warning((folder / name).string() + ": passed over " + counted(count, "line") + " that begin" +
                    (count == 1 ? "s" : "") + " with " + word_text(word));
    }
    all.merge(file.materials);
  }
  return all;
}

ImportedModel imported_model(const std::filesystem::path& file, const std::string& unit) {
  const std::string ending = lower_case(file.extension().string());
  if (ending != ".obj") {
    throw UnsupportedError(file.string() + ": found a file that ends in " + word_text(ending) +
                           ", expected .obj; a scene names OFF, PLY and STL files itself, as meshes, and other formats "
                           "are not available in this version");
  }
  const FileText text = file_text(file, largest_imported_file);
  if (!text.problem.empty()) throw SceneError(file.string() + ": found " + text.problem + "; expected an OBJ file");
  const nlohmann::json document;
  const std::string source = file.string();
  const JsonNode node(document, source);
  const MeshSource mesh{node, file.filename().string()};
  ImportedModel model{obj_soup(text.text, mesh), {}, {}};
  model.checked = checked_facets(model.soup, mesh, unit);
  for (const std::vector<std::string>& doubts : {model.soup.doubts, model.checked.doubts}) {
    for (const std::string& doubt : doubts) {
      if (!doubt.empty()) print_warning(source + ": " + doubt);
    }
  }
  if (model.soup.facets.empty()) throw SceneError(source + ": found no facet; expected a line that begins with f");
  model.materials = materials_of(model.soup, file.parent_path());
  return model;
}

/// The list's materials, each one of the model's.
std::map<std::string, std::string> chosen_materials(const std::string& option, const std::string& text, bool has_values,
                                                    const PolygonSoup& soup) {
  std::map<std::string, std::string> chosen;
  if (text.empty()) return chosen;
  for (const std::string_view item : comma_separated(text)) {
    const std::size_t equals = has_values ? item.rfind('=') : std::string_view::npos;
    const std::string name(item.substr(0, equals));
    if (has_values && equals == std::string_view::npos) {
      throw UsageError(option + ": found '" + std::string(item) + "'; expected MATERIAL=RADIANCE");
    }
    if (std::ranges::find(soup.materials, name) == soup.materials.end()) {
      std::vector<std::string_view> all(soup.materials.begin(), soup.materials.end());
      throw UsageError(option + ": no facet has the material '" + name + "'" + nearest_text(name, all));
    }
    chosen[name] = has_values ? std::string(item.substr(equals + 1)) : "";
  }
  return chosen;
}

/// A name that scenes allow: none of '/', '\\', '#', and not twice.
std::string element_name(const std::string& wanted, std::set<std::string>& taken) {
  std::string name = wanted.empty() ? "model" : wanted.substr(0, 150);
  for (char& c : name) {
    if (c == '/' || c == '\\' || c == '#' || static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '_';
  }
  if (name == "." || name == "..") name += '_';
  std::string unique = name;
  for (int k = 2; !taken.insert(unique).second; ++k) unique = name + ' ' + std::to_string(k);
  return unique;
}

Json channels_json(const std::array<double, 3>& v) {
  return v[0] == v[1] && v[1] == v[2] ? Json(v[0]) : Json{v[0], v[1], v[2]};
}

Json material_json(const std::string& name, const FileMaterial& material) {
  Json json = {{"name", name}, {"model", "blinn"}};
  if (material.diffuse) json["diffuse"] = channels_json(*material.diffuse);
  if (material.specular) json["specular"] = channels_json(*material.specular);
  if (material.exponent) json["exponent"] = static_cast<int>(std::clamp(std::round(*material.exponent), 1.0, 10000.0));
  return json;
}

/// The scene, element by element.
class ImportedScene {
 public:
  ImportedScene(const ImportedModel& model, const ImportOptions& options, const std::string& mesh_file)
      : model_(model), mesh_file_(mesh_file) {
    document_ = {{"gnomon", 1}, {"dimension", 3}, {"length_unit", options.unit}};
    if (options.up == "y") document_["up"] = "y";
    for (const char* list : {"materials", "lights", "blockers", "receivers"}) document_[list] = Json::array();
    const auto lights = chosen_materials("--light", options.lights, true, model.soup);
    const auto receivers = chosen_materials("--receiver", options.receivers, false, model.soup);
    for (std::uint32_t m = 0; m < model.soup.materials.size(); ++m) {
      const std::string& name = model.soup.materials[m];
      const auto chosen = lights.find(name);
      add(m, chosen == lights.end() ? emission_of(name) : radiance_of(chosen->second), receivers.contains(name));
    }
  }

  const Json& document() const { return document_; }
  std::size_t count(const char* list) const { return document_.at(list).size(); }

 private:
  static std::array<double, 3> radiance_of(const std::string& text) {
    const double radiance = finite_value("--light", text, "MATERIAL=RADIANCE, the radiance a number above 0");
    if (!(radiance > 0)) throw UsageError("--light: found the radiance " + text + "; expected a number above 0");
    return {radiance, radiance, radiance};
  }

  std::array<double, 3> emission_of(const std::string& name) const {
    const auto found = model_.materials.find(name);
    return found == model_.materials.end() ? std::array<double, 3>{}
                                           : found->second.emission.value_or(std::array<double, 3>{});
  }

  void add(std::uint32_t material, const std::array<double, 3>& emission, bool is_receiver) {
    const std::string& name = model_.soup.materials[material];
    if (*std::ranges::max_element(emission) > 0) {
      if (is_receiver) throw UsageError("--receiver: facets of '" + name + "' are lights");
      add_lights(material, emission);
      return;
    }
    Json mesh = {{"name", element_name(name, names_)}, {"shape", "mesh"}, {"file", mesh_file_}};
    if (model_.soup.materials.size() > 1) mesh["usemtl"] = name;
    const auto known = model_.materials.find(name);
    if (known != model_.materials.end()) {
      document_["materials"].push_back(material_json(mesh["name"], known->second));
      mesh["material"] = mesh["name"];
    } else if (!name.empty()) {
      print_warning("no MTL file tells of the material " + word_text(name) + ", which reflects as a scene's do");
    }
    document_["blockers"].push_back(mesh);
    if (is_receiver) document_["receivers"].push_back(mesh);
  }

  /// One polygon for each facet.
  void add_lights(std::uint32_t material, const std::array<double, 3>& emission) {
    const double most = *std::ranges::max_element(emission);
    const std::array<double, 3> color{emission[0] / most, emission[1] / most, emission[2] / most};
    for (std::size_t f = 0; f < model_.checked.facets.size(); ++f) {
      if (model_.soup.facet_materials[model_.checked.numbers[f]] != material) continue;
      Json light = {{"name", element_name(model_.soup.materials[material], light_names_)},
                    {"shape", "polygon"},
                    {"vertices", Json::array()},
                    {"radiance", most}};
      for (const std::uint32_t v : model_.checked.facets[f]) {
        const Point3& p = model_.soup.vertices[v];
        light["vertices"].push_back({p.x, p.y, p.z});
      }
      if (color != std::array<double, 3>{1, 1, 1}) light["color"] = {color[0], color[1], color[2]};
      document_["lights"].push_back(std::move(light));
    }
  }

  const ImportedModel& model_;
  std::string mesh_file_;
  Json document_;
  std::set<std::string> names_, light_names_;
};

/// One element a line.
std::string scene_lines(const Json& document) {
  std::string text = "{ ";
  for (const auto& [key, value] : document.items()) {
    text += (text.size() > 2 ? ",\n  " : "") + Json(key).dump() + ": ";
    if (!value.is_array() || value.empty()) {
      text += value.dump();
      continue;
    }
    for (std::size_t k = 0; k < value.size(); ++k) text += (k == 0 ? "[\n    " : ",\n    ") + value[k].dump();
    text += " ]";
  }
  return text + " }\n";
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

}  // namespace

ExitCode import_command(Arguments arguments) {
  CommandLine app("Makes a scene of an OBJ file with its materials: lamps are lights, all else blocks.",
                  "gnomon import");
  ImportOptions options;
  add_options(app, options);
  if (!app.parse(arguments)) return ExitCode::done;
  if (!length_unit_named(options.unit)) {
    throw UsageError("--unit: found '" + options.unit + "'; expected m, mm, cm, km, in or ft");
  }
  if (options.up != "y" && options.up != "z") throw UsageError("--up: found '" + options.up + "'; expected y or z");
  require_place("--out", options.out, OutputKind::json);
  require_unread("--out", options.out, {options.file});
  const std::string mesh_file = options.out == "-" ? std::filesystem::path(options.file).filename().string()
                                                   : name_beside(options.file, options.out);
  const ImportedModel model = imported_model(options.file, options.unit);
  const ImportedScene scene(model, options, mesh_file);
  const std::string text = scene_lines(scene.document());
  if (options.out == "-") {
    std::cout << text;
    return ExitCode::done;
  }
  // What the scene reader would refuse is refused here, before anything is written.
  parse_scene(text, options.out, std::filesystem::absolute(options.out).parent_path());
  write_output_file(options.out, text);
  if (!options.quiet) {
    std::cout << labelled("written", options.out + ": " + counted(scene.count("lights"), "light") + ", " +
                                         counted(scene.count("blockers"), "blocker") + ", " +
                                         counted(scene.count("receivers"), "receiver"));
  }
  return ExitCode::done;
}

}  // namespace gnomon
