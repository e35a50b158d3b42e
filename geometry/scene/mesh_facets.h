#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/scene/mesh_formats.h"
#include "geometry/scene/polygon_rings.h"

namespace gnomon {

/// The facets of a mesh file that are polygons.
struct CheckedFacets {
  std::vector<Ring> facets;            ///< without equal neighbours; holes hang together by seams
  std::vector<std::uint32_t> numbers;  ///< of each facet, its number in the file
  std::vector<std::string> doubts;     ///< what was mended, in words that follow the mesh's name
};

/// Looks at every facet. Those without an area are left out, equal neighbours count once, bent facets are accepted:
/// each with a doubt.
///
/// Throws: SceneError, with the line (in binary files the number) of a facet that is no polygon.
CheckedFacets checked_facets(const PolygonSoup& soup, const MeshSource& source, const std::string& length_unit);

}  // namespace gnomon
