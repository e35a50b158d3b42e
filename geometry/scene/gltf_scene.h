#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/scene/material_file.h"
#include "geometry/scene/mesh_formats.h"

namespace gnomon {

/// A light of KHR_lights_punctual.
struct PunctualLight {
  std::string name;
  bool is_directional = false;
  Point3 place;                       ///< its position, or the direction in which it shines
  std::array<double, 3> intensity{};  ///< of each channel: of a point light in W/sr, of a directional one in W/m²
};

/// A camera as a file has it.
struct FileCamera {
  Point3 eye, look_at, up;    ///< `up` as a direction
  double vertical_angle = 0;  ///< degrees, of the whole picture
  double aspect = 1;          ///< width over height
};

/// The triangles of a glTF scene, their materials, its punctual lights and the first of its cameras in perspective.
struct GltfScene {
  PolygonSoup soup;                                    ///< its doubts tell what was passed over, a kind each
  std::vector<std::optional<FileMaterial>> materials;  ///< of each of the soup's materials; none of facets without one
  std::vector<PunctualLight> lights;
  std::optional<FileCamera> camera;
};

/// Reads a glTF 2.0 file: the triangles of the scene that it shows, placed by its nodes.
///
/// Positions are floats, which doubles hold exactly; where a node moves or turns them the result is rounded. A node
/// that mirrors turns facets round, so that fronts stay fronts. Emission is emissiveFactor times the strength of
/// KHR_materials_emissive_strength; of a base color c and the metallic share m, c (1 - m) is reflected diffusely and
/// c m specularly, with the exponent 2 / a² - 2 of a microfacet distribution of the width a = roughness². Numbers of
/// light, photometric ones in glTF, are taken as watts. Textures, points and lines, skins, morph targets, animations,
/// spot lights and all other cameras are passed over.
///
/// Throws: SceneError with the JSON pointer; UnsupportedSceneError for what GltfFile does not read.
GltfScene gltf_scene(std::string_view bytes, const std::string& source, const std::filesystem::path& folder);

}  // namespace gnomon
