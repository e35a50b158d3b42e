#include "apps/gnomon/imported_model.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/console.h"
#include "apps/gnomon/text.h"
#include "geometry/scene/file_text.h"
#include "geometry/scene/mesh_text.h"
#include "geometry/scene/radiance_text.h"
#include "gnomon/errors.h"
#include "gnomon/scene.h"

namespace gnomon {
namespace {

constexpr std::size_t largest_imported_file = std::size_t{128} << 20;

/// Materials of the files that an OBJ file names, found beside it; what is missing or not used is told.
std::map<std::string, FileMaterial> materials_beside(const PolygonSoup& soup, const std::filesystem::path& folder) {
  std::map<std::string, FileMaterial> all;
  for (const std::string& name : soup.material_files) {
    if (name == "mtllib") continue;
    const std::string path = (folder / name).string();
    const FileText text = file_text(path, largest_imported_file, FileKind::regular);
    if (!text.problem.empty()) {
      print_warning(path + ": found " + text.problem + "; its materials are not known");
      continue;
    }
    MaterialFile file = material_file(text.text);
    for (const auto& [word, count] : file.passed_over) {
      print_warning(path + ": passed over " + counted(count, "line") + " that begin" + (count == 1 ? "s" : "") +
                    " with " + word_text(word));
    }
    all.merge(file.materials);
  }
  return all;
}

void read_obj(ImportedModel& model, std::string_view text, const MeshSource& source,
              const std::filesystem::path& folder) {
  model.soup = obj_soup(text, source);
  const std::map<std::string, FileMaterial> known = materials_beside(model.soup, folder);
  for (const std::string& name : model.soup.materials) {
    const auto found = known.find(name);
    model.materials.push_back(found == known.end() ? std::nullopt : std::optional(found->second));
    if (found != known.end() || name.empty()) continue;
    print_warning("no MTL file tells of the material " + word_text(name) + ", which reflects as a scene's do");
  }
}

/// A format without materials: all facets are of one that has no name.
template <PolygonSoup (*soup_of)(std::string_view, const MeshSource&)>
void read_plain_mesh(ImportedModel& model, std::string_view text, const MeshSource& source,
                     const std::filesystem::path&) {
  model.soup = soup_of(text, source);
  model.soup.materials = {""};
  model.soup.facet_materials.assign(model.soup.facets.size(), 0);
  model.materials = {std::nullopt};
}

void read_radiance(ImportedModel& model, std::string_view text, const MeshSource& source,
                   const std::filesystem::path&) {
  RadianceScene scene = radiance_scene(text, source);
  model.form = ModelForm::polygons;
  model.soup = std::move(scene.soup);
  model.names = std::move(scene.names);
  model.materials = std::move(scene.materials);
}

void read_gltf(ImportedModel& model, std::string_view text, const MeshSource& source,
               const std::filesystem::path& folder) {
  GltfScene scene = gltf_scene(text, (folder / source.file).string(), folder);
  model.form = ModelForm::written_mesh;
  model.is_y_up = true;
  model.soup = std::move(scene.soup);
  model.materials = std::move(scene.materials);
  model.lights = std::move(scene.lights);
  model.camera = scene.camera;
}

using ModelReader = void (*)(ImportedModel&, std::string_view, const MeshSource&, const std::filesystem::path&);

ModelReader model_reader(const std::filesystem::path& file) {
  const std::string ending = lower_case(file.extension().string());
  if (ending == ".obj") return read_obj;
  if (ending == ".off") return read_plain_mesh<off_soup>;
  if (ending == ".ply") return read_plain_mesh<ply_soup>;
  if (ending == ".stl") return read_plain_mesh<stl_soup>;
  if (ending == ".rad") return read_radiance;
  if (ending == ".gltf" || ending == ".glb") return read_gltf;
  throw UnsupportedError(
      file.string() + ": found a file that ends in " + word_text(ending) +
      ", expected .gltf, .glb, .obj, .off, .ply, .rad or .stl; other formats are not available in this version");
}

}  // namespace

ImportedModel imported_model(const std::filesystem::path& file, const std::string& length_unit) {
  const ModelReader read = model_reader(file);
  const FileText text = file_text(file, largest_imported_file);
  const std::string source = file.string();
  if (!text.problem.empty()) throw SceneError(source + ": found " + text.problem + "; expected a file with a model");
  const nlohmann::json document;
  const JsonNode node(document, source);
  const MeshSource mesh{node, file.filename().string()};
  ImportedModel model;
  model.title = file.stem().string();
  read(model, text.text, mesh, file.parent_path());
  model.checked = checked_facets(model.soup, mesh, length_unit);
  for (const std::vector<std::string>& doubts : {model.soup.doubts, model.checked.doubts}) {
    for (const std::string& doubt : doubts) {
      if (!doubt.empty()) print_warning(source + ": " + doubt);
    }
  }
  if (model.checked.facets.empty()) throw SceneError(source + ": found no facet with an area; expected at least one");
  return model;
}

}  // namespace gnomon
