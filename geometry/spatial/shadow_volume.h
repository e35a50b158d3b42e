#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/spatial/convex_blocker.h"
#include "geometry/spatial/extremal_planes.h"

namespace gnomon {

/// What a bounding plane or facet of a volume comes from. The numbers are those of the `facet_kind` arrays in files.
enum class FacetKind : std::uint8_t {
  blocker_face = 0,
  separating_blocker_plane = 1,
  separating_light_plane = 2,
  supporting_blocker_plane = 3,
  clip_box = 4,
  light_plane = 5,
};

/// The name of a bounding plane: its kind and the input elements it goes through; -1 where there is none.
/// `edge_index` is a light edge and `vertex_index` a blocker vertex for separating light planes, the other way round
/// for blocker planes. For the clip box `edge_index` is the side: 0 to 5 for x min, x max, y min, y max, z min, z max.
struct FacetName {
  FacetKind kind;
  std::int32_t edge_index = -1;
  std::int32_t vertex_index = -1;

  friend bool operator==(const FacetName&, const FacetName&) = default;
};

/// A closed half-space bounded by the plane through three input points.
/// Orientation: the half-space is the negative side; x is on the positive side if (x, a, b, c) is positively oriented
/// as CGAL's orientation(a, b, c, x) says, that is, a, b, c run counterclockwise seen from x.
struct HalfSpace {
  FacetName name;
  std::array<Point3, 3> plane;
  bool third_is_direction = false;  ///< the plane goes through two points and along a vector: a directional light's
};

/// Where a point lies with respect to a volume.
enum class Side { inside, boundary, outside };

/// A convex volume as an intersection of named closed half-spaces; empty list: all of space.
struct ConvexVolume {
  std::vector<HalfSpace> half_spaces;
  bool empty = false;  ///< there is no such volume (with an interior), and the list says nothing

  /// Exactness: signs of orientation determinants of input points.
  /// Cost:      O(number of half-spaces).
  Side oriented_side(const Point3& point) const;
};

/// What is known of a volume before anything is constructed.
struct VolumeFacts {
  bool empty = true;
  bool bounded = true;
  std::uint32_t components = 0;
};

/// The shadow volumes of one light and one convex blocker, as names and half-spaces.
///
/// The volumes are closures of interiors. occlusion = points that lose some of the light, umbra = points that lose all
/// of it, penumbra = the rest of the occlusion (never convex, so it has no half-space form; see
/// spatial/volume_mesh.h). The umbra of a solid contains the solid; what lies outside of it may fall into pockets.
struct ShadowVolumes {
  ExtremalPlanes planes;
  ConvexVolume occlusion;
  ConvexVolume umbra;
  VolumeFacts occlusion_facts;
  VolumeFacts umbra_facts;
  VolumeFacts penumbra_facts;
  std::uint32_t umbra_pockets = 0;  ///< connected pieces of the umbra outside a solid; 0 for flat blockers
};

/// The shadow volumes of a pair, in any position.
///
/// Requires:   is_supported(light, blocker): all pairs but some of lights whose vertices were rounded off their plane.
/// Degenerate: a flat blocker coplanar with the light, and one behind a one-sided light, throw no shadow. A light that
///             reaches into a solid darkens all of space to some degree.
/// Exactness:  all decisions are exact.
/// Throws:     PreconditionError.
/// After:      [CF91] Theorems 1 to 3; [P93] §4.2.3.1, §5.2.3.
ShadowVolumes shadow_volumes(const Light& light, const ConvexBlocker& blocker);

/// The occlusion volume of any convex light and any convex blocker: the convex hull of the shadows of the light's
/// vertices, cut by the plane of a one-sided light.
///
/// Requires, Degenerate, Exactness, Throws: as shadow_volumes.
/// After:      [P93] §5.2.3.
ConvexVolume convex_hull_shadow_volume(const Light& light, const ConvexBlocker& blocker);

}  // namespace gnomon
