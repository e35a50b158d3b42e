#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/exact_number.h"
#include "geometry/spatial/shadow_volume.h"

namespace gnomon {

struct MeshTriangle {
  std::array<std::uint32_t, 3> vertices;  ///< counterclockwise seen from outside the volume
  std::uint32_t facet;                    ///< index into VolumeMesh::facets
};

/// The boundary of a volume cut by a box: a closed triangle surface (each edge twice, in opposite directions),
/// normals outward, no vertex inside another triangle's edge. Empty if the volume has no interior in the box.
/// Exactness: connectivity is decided exactly; vertices are constructed exactly and each coordinate is rounded to the
/// nearest double. `volume` is that of the exact mesh, 0 if it was not asked for.
struct VolumeMesh {
  std::vector<Point3> vertices;
  std::vector<FacetName> facets;
  std::vector<MeshTriangle> triangles;
  ExactNumber volume;
  bool truncated = false;  ///< true if a side of the clip box bounds it
};

/// A volume cut by a box as convex polyhedra that share no interior point.
/// Orientation: faces run counterclockwise seen from outside their cell. Rounding as in VolumeMesh.
struct VolumeCells {
  using Face = std::vector<std::uint32_t>;
  struct Cell {
    std::vector<Face> faces;
  };
  std::vector<Point3> vertices;
  std::vector<Cell> cells;
};

/// One extremal plane cut by the box: a convex polygon, empty where the plane misses the box.
/// Orientation: counterclockwise seen from the plane's positive side. Rounding as in VolumeMesh.
struct PlanePolygon {
  FacetName name;
  std::vector<Point3> vertices;
};

/// Everything of one pair that is drawn or written.
struct ShadowMeshes {
  VolumeMesh occlusion;
  VolumeMesh umbra;
  VolumeMesh penumbra;
  VolumeMesh umbra_pockets;  ///< the umbra of a solid without the solid: none, one or more closed surfaces
  VolumeCells umbra_cells;
  VolumeCells penumbra_cells;
  std::vector<PlanePolygon> extremal_planes;
};

/// What to make of a pair; occlusion and umbra are always made.
struct ShadowParts {
  bool penumbra = true;  ///< its surface, and that of the umbra's pockets
  bool cells = true;     ///< umbra and penumbra as convex cells
  bool planes = true;    ///< the extremal planes cut by the box
  bool volumes = true;   ///< exact volumes; they take most of the time. Left out they are 0
};

/// The volumes of a pair in any position as closed meshes and convex cells, cut exactly by the box.
///
/// Requires: is_supported(light, blocker); box.min < box.max in every coordinate, all finite.
/// Cost:     occlusion and umbra O(k log k) expected for k half-spaces; the cells O(k^2).
/// Throws:   PreconditionError.
ShadowMeshes shadow_meshes(const Light& light, const ConvexBlocker& blocker, const Box3& box,
                           const ShadowParts& parts = {});

}  // namespace gnomon
