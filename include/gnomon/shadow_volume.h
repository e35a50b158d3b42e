#pragma once

/// @file
/// The shadow of one light and one blocker as half-spaces: on which side is a point?
///
///     #include <gnomon/shadow_volume.h>
///     int main() {
///       using namespace gnomon;
///       const Light lamp = AreaLight{ConvexPolygon::from_points({{-2, -2, 4}, {-2, 2, 4}, {2, 2, 4}, {2, -2, 4}})};
///       const ConvexPolygon board = ConvexPolygon::from_points({{-1, -1, 3}, {1, -1, 3}, {1, 1, 3}, {-1, 1, 3}});
///       const ShadowVolumes shadow = shadow_volumes(lamp, board);
///       return shadow.umbra.oriented_side({0, 0, 2}) == Side::boundary ? 0 : 1;  // the apex, decided exactly
///     }

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/pair.h"
#include "gnomon/point.h"

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

/// The name of a bounding plane: its kind and the input elements it goes through, where there are any.
/// `edge_index` is a light edge and `vertex_index` a blocker vertex for separating light planes, the other way round
/// for blocker planes. For the clip box `edge_index` is the side: 0 to 5 for x min, x max, y min, y max, z min, z max.
struct FacetName {
  FacetKind kind;
  std::optional<std::uint32_t> edge_index = {};
  std::optional<std::uint32_t> vertex_index = {};

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
/// Requires:   no pair_refusal(light, blocker): all pairs but some of lights whose vertices were rounded off their
/// plane. Degenerate: a flat blocker coplanar with the light, and one behind a one-sided light, throw no shadow. A
/// light that
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

/// The bounding plane of a half-space as numbers a, b, c, d: the half-space is a x + b y + c z + d <= 0.
///
/// Definition: (a, b, c) is the cross product of the plane's two edges at its first point, so that it points out of the
///             half-space; its length says nothing. Where the largest of the four would not lie between 2^-900 and
///             2^900, as it does for scenes of usual sizes, all four are multiplied by the power of two that brings it
///             between 1/2 and 2, so that doubles hold it.
/// Exactness:  exact rationals, and each correctly rounded. Rounded alone, they no longer hold for every point.
std::array<ExactNumber, 4> plane_coefficients(const HalfSpace& half_space);

}  // namespace gnomon
