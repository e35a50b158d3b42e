#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "geometry/scene/coplanar_facets.h"
#include "geometry/scene/gltf_scene.h"
#include "geometry/scene/material_file.h"
#include "geometry/scene/mesh_facets.h"
#include "geometry/scene/radiance_text.h"
#include "gnomon/scene.h"

namespace {

int read_gltf(std::string_view bytes) {
  try {
    gnomon::gltf_scene(bytes, "fuzz.gltf", ".");
  } catch (const gnomon::SceneError&) {
  }
  return 0;
}

}  // namespace

/// One run of the fuzzer: the first byte chooses a glTF file, the text of a Radiance scene or an MTL file, the rest is
/// the file. Any bytes must end in polygons, joined ones too, in materials, or in a SceneError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  if (data[0] != 'g' && data[0] % 2 == 1) {
    gnomon::material_file(text);
    gnomon::emitting_materials(text);
    return 0;
  }
  if (data[0] == 'g') return read_gltf(text);
  const nlohmann::json document;
  const std::string scene = "fuzz.rad";
  const gnomon::JsonNode node(document, scene);
  const gnomon::MeshSource source{node, "fuzz.rad"};
  try {
    const gnomon::RadianceScene read = gnomon::radiance_scene(text, source);
    const gnomon::CheckedFacets checked = gnomon::checked_facets(read.soup, source, "m");
    gnomon::joined_facets(read.soup.vertices, checked.facets);
  } catch (const gnomon::SceneError&) {
  }
  return 0;
}
