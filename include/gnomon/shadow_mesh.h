#pragma once

/// @file
/// The shadow of one light and one blocker as meshes, cut by a box.
///
///     #include <gnomon/shadow_mesh.h>
///     int main() {
///       using namespace gnomon;
///       const Light lamp = AreaLight{ConvexPolygon::from_points({{-2, -2, 4}, {-2, 2, 4}, {2, 2, 4}, {2, -2, 4}})};
///       const ConvexPolygon board = ConvexPolygon::from_points({{-1, -1, 3}, {1, -1, 3}, {1, 1, 3}, {-1, 1, 3}});
///       const ShadowMeshes shadow = shadow_meshes(lamp, board, {{-9, -9, 0}, {9, 9, 9}});
///       return shadow.umbra.triangles.size() == 6 && shadow.umbra.volume.exact == "4/3" ? 0 : 1;  // a pyramid
///     }

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/light.h"
#include "gnomon/point.h"
#include "gnomon/shadow_volume.h"

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
/// Requires: no pair_refusal(light, blocker); box.min < box.max in every coordinate, all finite.
/// Cost:     occlusion and umbra O(k log k) expected for k half-spaces; the cells O(k^2).
/// Throws:   PreconditionError.
ShadowMeshes shadow_meshes(const Light& light, const ConvexBlocker& blocker, const Box3& box,
                           const ShadowParts& parts = {});

/// One light and one blocker, looked at once, for several questions. Copies share what was found; any number of threads
/// may ask.
class ShadowPair {
 public:
  ShadowPair(Light light, ConvexBlocker blocker);

  const ConvexBlocker& blocker() const;

  /// As pair_position and pair_refusal.
  Position position() const;
  std::string_view refusal() const;

  /// As shadow_volumes and shadow_meshes.
  ///
  /// Requires: no refusal.
  /// Throws:   PreconditionError.
  ShadowVolumes volumes() const;
  ShadowMeshes meshes(const Box3& box, const ShadowParts& parts = {}) const;

 private:
  struct Content;
  std::shared_ptr<const Content> content_;
};

/// The boundary of the union of several occlusion volumes.
struct MergedOcclusion {
  VolumeMesh mesh;                        ///< closed as VolumeMesh says, its exact volume included
  std::vector<std::uint32_t> facet_part;  ///< for every facet of the mesh the part of the blocker it comes from
};

/// Unites the occlusion volumes of the convex parts of one blocker, a part at a time: what of each part's boundary lies
/// in no other part is the boundary of the union.
///
/// Definition: the union of the parts' occlusion volumes, each cut by the box: the occlusion of their union. (The umbra
///             of a union is more than the union of umbrae, so umbrae are not united.) A facet is what one part shows
///             of one of its planes; where several parts have it in common, the first one does.
/// Degenerate: parts may share corners, edges, sides, planes, or all. Where the union touches itself along an edge or
///             at a vertex, each of the sheets has vertices of its own at the same place; an edge that two sheets would
///             still share is divided at its middle. A part without occlusion adds nothing.
/// Exactness:  all decisions and the volume are exact; each coordinate is rounded to the nearest double.
/// Cost:       n parts with m planes each: O(n m) facets, each compared with n parts and united in its plane: grows
///             with the square of n, or a little faster, where all shadows overlap.
class OcclusionMerger {
 public:
  /// Requires: no pair_refusal(light, part) of any part; box.min < box.max in every coordinate, all finite.
  /// Throws:   PreconditionError.
  OcclusionMerger(const Light& light, std::span<const ConvexBlocker> parts, const Box3& box);
  OcclusionMerger(OcclusionMerger&&) noexcept;
  OcclusionMerger& operator=(OcclusionMerger&&) noexcept;
  ~OcclusionMerger();

  /// How many parts are still to be compared with the others.
  std::size_t remaining() const;
  /// Compares the next part with all others. Requires: remaining() > 0.
  void advance();
  /// Requires: remaining() == 0.
  MergedOcclusion result() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The union of the occlusion volumes of the convex parts of one blocker, all at once.
///
/// Requires, Throws: as OcclusionMerger.
MergedOcclusion merged_occlusion(const Light& light, std::span<const ConvexBlocker> parts, const Box3& box);

}  // namespace gnomon
