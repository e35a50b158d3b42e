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
/// nearest double. `volume` is that of the exact mesh.
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
  VolumeCells umbra_cells;
  VolumeCells penumbra_cells;
  std::vector<PlanePolygon> extremal_planes;
};

/// The volumes of a pair as closed meshes and convex cells, cut exactly by the box.
///
/// Requires: pair_position(light, blocker) == Position::standard; box.min < box.max in every coordinate, all finite.
/// Cost:     O(m (n + m)) exact decisions: about a millisecond for quadrilaterals, seconds for 500-gons.
/// Throws:   PreconditionError.
ShadowMeshes shadow_meshes(const Light& light, const ConvexPolygon& blocker, const Box3& box);

}  // namespace gnomon
