#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/scene/json_node.h"
#include "gnomon/point.h"

namespace gnomon {

/// Facets as lists of vertex numbers, as a mesh file holds them.
struct PolygonSoup {
  std::vector<Point3> vertices;
  std::vector<std::vector<std::uint32_t>> facets;  ///< of any length, empty ones too
  std::vector<std::size_t> lines;                  ///< of each facet in a file of lines, the number of its own
  std::uint64_t first_number = 0;                  ///< how the file calls its first vertex
  std::vector<std::string> doubts;                 ///< what was passed over, in words that follow the file's name
  std::vector<std::string> material_files;         ///< OBJ: as written
  std::vector<std::string> materials;              ///< OBJ: those of facets; "" of facets without one
  std::vector<std::uint32_t> facet_materials;      ///< OBJ: of each facet, the number of its material
  std::vector<Point3> normals;                     ///< OBJ: as written; zero where that is no vector
  /// OBJ: of every corner of every facet, the number of its normal, or one that no normal has.
  std::vector<std::vector<std::uint32_t>> corner_normals;
};

/// Where a facet stands: "line 7, facet 0", or "facet 0" in files without lines.
std::string facet_place(const PolygonSoup& soup, std::size_t facet);

/// The mesh file that is being read and the place in the scene that asked for it.
struct MeshSource {
  const JsonNode& node;
  std::string file;  ///< empty if the mesh stands in the scene itself

  /// `place` says where in the mesh file: "line 7", "facet 12".
  [[noreturn]] void refuse(std::string_view place, std::string_view found, std::string_view expected) const;
};

/// The readers of single formats. Vertices are finite, vertex numbers within range. Normals but those of OBJ, colours,
/// textures and elements of other kinds are passed over; so are lines whose first word is not known, with a doubt.
///
/// Throws: SceneError.
PolygonSoup obj_soup(std::string_view text, const MeshSource& source);
PolygonSoup off_soup(std::string_view text, const MeshSource& source);
PolygonSoup ply_soup(std::string_view text, const MeshSource& source);  ///< ASCII and binary of both byte orders
PolygonSoup stl_soup(std::string_view text, const MeshSource& source);  ///< ASCII and binary

}  // namespace gnomon
