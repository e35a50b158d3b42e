#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.h"
#include "geometry/scene/json_node.h"

namespace gnomon {

/// Facets as lists of vertex numbers, as a mesh file holds them.
struct PolygonSoup {
  std::vector<Point3> vertices;
  std::vector<std::vector<std::uint32_t>> facets;
};

/// The mesh file that is being read and the place in the scene that asked for it.
struct MeshSource {
  const JsonNode& node;
  std::string file;

  /// `place` says where in the mesh file: "line 7", "facet 12".
  [[noreturn]] void refuse(std::string_view place, std::string_view found, std::string_view expected) const;
};

/// The readers of single formats. Vertices are finite; every facet has at least 3 of them, all within range. Normals,
/// colours, textures and elements of other kinds are passed over.
///
/// Throws: SceneError.
PolygonSoup obj_soup(std::string_view text, const MeshSource& source);
PolygonSoup off_soup(std::string_view text, const MeshSource& source);
PolygonSoup ply_soup(std::string_view text, const MeshSource& source);  ///< ASCII and binary of both byte orders
PolygonSoup stl_soup(std::string_view text, const MeshSource& source);  ///< ASCII and binary

}  // namespace gnomon
