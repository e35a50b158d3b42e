#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/scene/gltf_scene.h"
#include "geometry/scene/material_file.h"
#include "geometry/scene/mesh_facets.h"
#include "geometry/scene/mesh_formats.h"

namespace gnomon {

/// How a scene holds a model.
enum class ModelForm {
  mesh_file,     ///< it names the file, which its meshes are read from
  written_mesh,  ///< as meshes with vertices and facets
  polygons,      ///< as polygons, each by itself
};

/// A model as its files have it.
struct ImportedModel {
  std::string title;  ///< what facets without a material are called: the file's stem
  ModelForm form = ModelForm::mesh_file;
  bool is_y_up = false;                                ///< as the format has it
  PolygonSoup soup;                                    ///< with a material for each facet, "" where the file has none
  CheckedFacets checked;                               ///< those that are polygons
  std::vector<std::optional<FileMaterial>> materials;  ///< of each of the soup's materials, where it is known
  std::vector<std::string> names;                      ///< of each facet, in files that name them
  std::vector<PunctualLight> lights;                   ///< that are no facets
  std::optional<FileCamera> camera;

  /// What the program calls a material.
  const std::string& material_title(std::size_t material) const {
    return soup.materials[material].empty() ? title : soup.materials[material];
  }
};

/// Reads an OBJ file with its MTL files, an OFF, PLY or STL file, a glTF file with its buffers, or the text of a
/// Radiance scene. What is mended, missing or passed over is told on stderr, one line a kind.
///
/// Throws: SceneError with the file's line; UnsupportedError for other formats.
ImportedModel imported_model(const std::filesystem::path& file, const std::string& length_unit);

}  // namespace gnomon
