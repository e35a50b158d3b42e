#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/spatial/convex_blocker.h"
#include "geometry/spatial/light.h"
#include "geometry/spatial/volume_mesh.h"

namespace gnomon {

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
///             with the square of n, or a little faster, where all shadows overlap. Measured on a rough sheet of
///             triangles under a square light: 32 parts in 0.9 s, 98 in 12 s.
class OcclusionMerger {
 public:
  /// Requires: is_supported(light, part) for every part; box.min < box.max in every coordinate, all finite.
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
