#include "apps/gnomon/imported_scene.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "apps/gnomon/commands.h"
#include "geometry/numbers/place_key.h"
#include "geometry/scene/coplanar_facets.h"
#include "gnomon/convex_polygon.h"

namespace gnomon {
namespace {

using Json = nlohmann::ordered_json;

/// The text with a sign in place of bytes that are no UTF-8, which JSON cannot hold.
std::string as_utf8(const std::string& text) {
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// Names that are taken, each with the last number that was put behind it.
using TakenNames = std::map<std::string, int>;

/// A name that scenes allow: UTF-8, none of '/', '\\', '#', and not twice.
std::string element_name(const std::string& wanted, TakenNames& taken) {
  std::string name = as_utf8(wanted.empty() ? "model" : wanted.substr(0, 150));
  for (char& c : name) {
    if (c == '/' || c == '\\' || c == '#' || static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '_';
  }
  if (name == "." || name == "..") name += '_';
  const auto [entry, is_new] = taken.try_emplace(name, 1);
  if (is_new) return name;
  std::string unique;
  do {
    unique = name + ' ' + std::to_string(++entry->second);
  } while (!taken.try_emplace(unique, 1).second);
  return unique;
}

/// Facets' places by material.
std::vector<std::vector<std::size_t>> facets_by_material(const ImportedModel& model) {
  std::vector<std::vector<std::size_t>> facets(model.soup.materials.size());
  for (std::size_t f = 0; f < model.checked.facets.size(); ++f) {
    facets[model.soup.facet_materials[model.checked.numbers[f]]].push_back(f);
  }
  return facets;
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

Json camera_json(const FileCamera& camera) {
  constexpr double height = 360;
  const auto json = [](const Point3& p) { return Json{p.x, p.y, p.z}; };
  return {{"eye", json(camera.eye)},
          {"look_at", json(camera.look_at)},
          {"up", json(camera.up)},
          {"fov", camera.vertical_angle},
          {"width", static_cast<int>(std::clamp(std::round(height * camera.aspect), 1.0, 16384.0))},
          {"height", static_cast<int>(height)}};
}

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

/// The document, element by element.
class SceneWriter {
 public:
  explicit SceneWriter(const ImportChoice& choice) : choice_(choice) {
    document_ = {{"gnomon", 1}, {"dimension", 3}, {"length_unit", choice.unit}};
    if (choice.up == "y") document_["up"] = "y";
    for (const char* list : {"materials", "lights", "blockers", "receivers"}) document_[list] = Json::array();
  }

  void add(const ImportedModel& model, const std::string& mesh_file) {
    const std::vector<std::vector<std::size_t>> facets = facets_by_material(model);
    for (std::uint32_t m = 0; m < facets.size(); ++m) {
      if (!facets[m].empty()) add_facets(model, m, facets[m], mesh_file);
    }
    for (const PunctualLight& light : model.lights) add_light(light);
    if (model.camera && !document_.contains("camera")) document_["camera"] = camera_json(*model.camera);
  }

  ImportedScene scene() {
    result_.text = scene_lines(document_);
    result_.lights = document_["lights"].size();
    result_.blockers = document_["blockers"].size();
    result_.receivers = document_["receivers"].size();
    return std::move(result_);
  }

 private:
  std::array<double, 3> emission_of(const ImportedModel& model, std::uint32_t material) const {
    const auto chosen = choice_.lights.find(model.material_title(material));
    if (chosen != choice_.lights.end()) return {chosen->second, chosen->second, chosen->second};
    const std::optional<FileMaterial>& known = model.materials[material];
    return known ? known->emission.value_or(std::array<double, 3>{}) : std::array<double, 3>{};
  }

  void add_facets(const ImportedModel& model, std::uint32_t material, const std::vector<std::size_t>& facets,
                  const std::string& mesh_file) {
    const std::array<double, 3> emission = emission_of(model, material);
    const bool is_receiver = choice_.receivers.contains(model.material_title(material));
    if (*std::ranges::max_element(emission) > 0) {
      if (is_receiver) throw UsageError("--receiver: facets of '" + model.material_title(material) + "' are lights");
      add_lights(model, material, facets, emission);
    } else if (model.form == ModelForm::polygons) {
      add_polygons(model, material, facets, is_receiver);
    } else {
      add_mesh(model, material,
               model.form == ModelForm::mesh_file ? mesh_of(model, material, mesh_file) : written_mesh(model, facets),
               is_receiver);
    }
  }

  void add_blocker(Json element, bool is_receiver) {
    if (is_receiver) document_["receivers"].push_back(element);
    document_["blockers"].push_back(std::move(element));
  }

  /// Adds a material that is known. Returns its name, or an empty one.
  std::string added_material(const std::optional<FileMaterial>& material, const std::string& name) {
    if (!material) return {};
    std::string unique = element_name(name, material_names_);
    document_["materials"].push_back(material_json(unique, *material));
    return unique;
  }

  /// A name as a file has it, by which the scene can ask for it.
  static const std::string& named_in_scene(const std::string& name) {
    if (as_utf8(name) == name) return name;
    throw UnsupportedError("found the name '" + as_utf8(name) +
                           "' with bytes that are no UTF-8; expected UTF-8, in which a scene can write it "
                           "('iconv -f latin1 -t utf-8 FILE' makes it of Latin 1)");
  }

  static Json mesh_of(const ImportedModel& model, std::uint32_t material, const std::string& mesh_file) {
    Json keys = {{"file", named_in_scene(mesh_file)}};
    if (model.soup.materials.size() > 1) keys["usemtl"] = named_in_scene(model.soup.materials[material]);
    return keys;
  }

  /// The facets with the vertices that they need, each place once.
  static Json written_mesh(const ImportedModel& model, const std::vector<std::size_t>& facets) {
    Json keys = {{"vertices", Json::array()}, {"facets", Json::array()}};
    std::map<PlaceKey, std::size_t> known;
    for (const std::size_t f : facets) {
      Json corners = Json::array();
      for (const std::uint32_t v : model.checked.facets[f]) {
        const Point3& p = model.soup.vertices[v];
        const auto [entry, is_new] = known.try_emplace(place_key(p), known.size());
        if (is_new) keys["vertices"].push_back({p.x, p.y, p.z});
        corners.push_back(entry->second);
      }
      keys["facets"].push_back(std::move(corners));
    }
    return keys;
  }

  /// `keys` say which mesh it is.
  void add_mesh(const ImportedModel& model, std::uint32_t material, Json keys, bool is_receiver) {
    Json mesh = {{"name", element_name(model.material_title(material), names_)}, {"shape", "mesh"}};
    mesh.update(keys);
    const std::string name = added_material(model.materials[material], mesh["name"]);
    if (!name.empty()) mesh["material"] = name;
    add_blocker(std::move(mesh), is_receiver);
  }

  /// Any polygon that is not convex, with seams or bent ones among them, has the shape for concave ones.
  static Json polygon_json(const ImportedModel& model, const Ring& ring, const std::string& name) {
    std::vector<Point3> corners;
    Json vertices = Json::array();
    for (const std::uint32_t v : ring) {
      const Point3& p = corners.emplace_back(model.soup.vertices[v]);
      vertices.push_back({p.x, p.y, p.z});
    }
    return {{"name", name},
            {"shape", ConvexPolygon::defect(corners) ? "concave_polygon" : "polygon"},
            {"vertices", std::move(vertices)}};
  }

  /// What a facet is called: as the file calls it, or as its material.
  static const std::string& facet_name(const ImportedModel& model, std::size_t facet, std::uint32_t material) {
    return model.names.empty() ? model.material_title(material) : model.names[model.checked.numbers[facet]];
  }

  void add_polygons(const ImportedModel& model, std::uint32_t material, const std::vector<std::size_t>& facets,
                    bool is_receiver) {
    const std::string name = added_material(model.materials[material], model.material_title(material));
    for (const std::size_t f : facets) {
      Json polygon = polygon_json(model, model.checked.facets[f], element_name(facet_name(model, f, material), names_));
      if (!name.empty()) polygon["material"] = name;
      add_blocker(std::move(polygon), is_receiver);
    }
  }

  /// One polygon for each facet, or for facets that are joined.
  void add_lights(const ImportedModel& model, std::uint32_t material, const std::vector<std::size_t>& facets,
                  const std::array<double, 3>& emission) {
    std::vector<Ring> rings;
    for (const std::size_t f : facets) rings.push_back(model.checked.facets[f]);
    if (choice_.merges_coplanar) {
      std::vector<Ring> joined = joined_facets(model.soup.vertices, rings);
      if (joined.size() < rings.size()) {
        result_.joined += rings.size();
        result_.joined_to += joined.size();
      }
      rings = std::move(joined);
    }
    const bool is_as_before = rings.size() == facets.size();
    const double most = *std::ranges::max_element(emission);
    const std::array<double, 3> color{emission[0] / most, emission[1] / most, emission[2] / most};
    for (std::size_t k = 0; k < rings.size(); ++k) {
      const std::string& name = is_as_before ? facet_name(model, facets[k], material) : model.material_title(material);
      Json light = polygon_json(model, rings[k], element_name(name, light_names_));
      light["radiance"] = most;
      if (color != std::array<double, 3>{1, 1, 1}) light["color"] = {color[0], color[1], color[2]};
      const std::optional<FileMaterial>& known = model.materials[material];
      if (known && known->emits_both_ways) light["two_sided"] = true;
      document_["lights"].push_back(std::move(light));
    }
  }

  /// A light without size; none of no intensity.
  void add_light(const PunctualLight& of_file) {
    const double most = *std::ranges::max_element(of_file.intensity);
    if (!(most > 0)) return;
    const Point3& p = of_file.place;
    Json light = {{"name", element_name(of_file.name, light_names_)},
                  {"shape", of_file.is_directional ? "direction" : "point"},
                  {of_file.is_directional ? "direction" : "position", {p.x, p.y, p.z}},
                  {of_file.is_directional ? "irradiance" : "intensity", most}};
    const std::array<double, 3>& i = of_file.intensity;
    if (i[0] != i[1] || i[1] != i[2]) light["color"] = {i[0] / most, i[1] / most, i[2] / most};
    document_["lights"].push_back(std::move(light));
  }

  const ImportChoice& choice_;
  Json document_;
  ImportedScene result_;
  TakenNames names_, light_names_, material_names_;
};

}  // namespace

ImportedScene imported_scene(const std::vector<ImportedModel>& models, const std::vector<std::string>& mesh_files,
                             const ImportChoice& choice) {
  SceneWriter writer(choice);
  for (std::size_t k = 0; k < models.size(); ++k) writer.add(models[k], mesh_files[k]);
  return writer.scene();
}

}  // namespace gnomon
