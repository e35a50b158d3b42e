#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "geometry/scene/mesh_facets.h"
#include "geometry/scene/mesh_formats.h"
#include "gnomon/scene.h"

/// One run of the fuzzer: the first byte chooses the format, the rest is the file. Any bytes must end in polygons or in
/// a SceneError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const nlohmann::json document;
  const std::string scene = "fuzz.scene.json";
  const gnomon::JsonNode node(document, scene);
  const gnomon::MeshSource source{node, "mesh"};
  constexpr std::array readers = {gnomon::obj_soup, gnomon::off_soup, gnomon::ply_soup, gnomon::stl_soup};
  try {
    const gnomon::PolygonSoup soup =
        readers[data[0] % readers.size()]({reinterpret_cast<const char*>(data + 1), size - 1}, source);
    gnomon::checked_facets(soup, source, "m");
  } catch (const gnomon::SceneError&) {
  }
  return 0;
}
