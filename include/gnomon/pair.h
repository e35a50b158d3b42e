#pragma once

/// @file
/// One light and one blocker: how they stand to each other, and the planes that touch both.
///
///     #include <gnomon/pair.h>
///     int main() {
///       using namespace gnomon;
///       const Light lamp = PointLight{{0, 0, 4}};
///       const ConvexPolygon board = ConvexPolygon::from_points({{-1, -1, 3}, {1, -1, 3}, {0, 1, 3}});
///       const ExtremalPlanes planes = extremal_planes(lamp, board);  // by name: blocker edge and light vertex
///       return pair_position(lamp, board) == Position::standard && planes.supporting_blocker.size() == 3 ? 0 : 1;
///     }

#include <string_view>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/light.h"
#include "gnomon/names.h"

namespace gnomon {

/// How a light and a blocker stand to each other. The first that holds, in this order, is the pair's position:
/// coplanar, behind_light, both_cross, light_crosses_blocker_plane, blocker_crosses_light_plane, touching, standard.
enum class Position {
  standard,  ///< the light strictly on one side of the blocker's plane, and the blocker strictly in front of an area
             ///< light
  light_crosses_blocker_plane,  ///< the light has points strictly on both sides of the blocker's plane
  blocker_crosses_light_plane,  ///< the blocker has points strictly on both sides of an area light's plane
  both_cross,                   ///< both of these
  touching,      ///< nothing crosses, but the light reaches the blocker's plane, or the blocker the light's
  coplanar,      ///< the light lies in the blocker's plane
  behind_light,  ///< no point of the blocker strictly in front of a one-sided area light
};

/// The position's name as scripts read it.
std::string_view name(Position position);

/// The position of a pair.
///
/// Definition: for a solid (or a light whose vertices were rounded off their plane) the hulls take the place of the
///             polygons: the light crosses the blocker if it has a point strictly inside; it touches a solid if it has
///             none there, but one on its boundary.
/// Degenerate: a two-sided area light has two fronts. A directional light is in standard position, or coplanar with a
///             flat blocker whose plane its rays run along.
/// Exactness:  signs of orientation determinants of input points; exact arithmetic where a light meets a solid.
/// Cost:       O(n + m) for flat polygons.
Position pair_position(const Light& light, const ConvexBlocker& blocker);

/// Why the shadow of a pair is not computed, in words for people; empty if it is.
///
/// Definition: refused is the one kind of pair whose shadow is not that of the hulls: a light whose vertices were
/// rounded
///             off their plane, unless the plane of one of its hull's facets, or of the blocker's, holds the two
///             strictly apart, and the blocker lies strictly in front of a one-sided one.
std::string_view pair_refusal(const Light& light, const ConvexBlocker& blocker);

/// The plane through a blocker edge that touches the light, named by input elements alone.
struct BlockerPlane {
  MaybeIndex<BlockerEdge> edge;  ///< of a solid its place in its edges(); none if no file has it
  LightVertex vertex;

  friend bool operator==(const BlockerPlane&, const BlockerPlane&) = default;
};

/// The plane through a light edge (or the whole linear light) that touches the blocker.
struct LightPlane {
  MaybeIndex<LightEdge> edge;  ///< nothing for a diagonal of a light whose vertices were rounded off their plane
  BlockerVertex vertex;

  friend bool operator==(const LightPlane&, const LightPlane&) = default;
};

/// All extremal planes of one light and one convex blocker, flat or solid. Of a flat blocker and a light in standard
/// position they stand in the order of the blocker's (the light's) sides; of others in that of the half-spaces that
/// they bound. A polygon whose vertices were rounded is a solid: its diagonals are edges of no file.
///
/// Each plane is listed once with each contact it has: a plane through a blocker edge that holds the whole light (a
/// point light, a linear light coplanar with the edge) is separating and supporting. Where a light edge and a blocker
/// edge are coplanar, the blocker edge is named; where several vertices touch, the one of lowest index; where a side
/// consists of several collinear edges, the edge of lowest index.
struct ExtremalPlanes {
  std::vector<BlockerPlane> separating_blocker;  ///< one per side of a flat blocker
  std::vector<LightPlane> separating_light;      ///< through light edges, those coplanar with a blocker edge left out
  std::vector<BlockerPlane> supporting_blocker;  ///< one per side of a flat blocker
};

/// The extremal planes of a flat blocker in standard position; ShadowVolumes::planes has those of every pair.
///
/// Requires:   pair_position(light, blocker) == Position::standard.
/// Exactness:  signs of orientation determinants of input points; nothing is constructed.
/// Cost:       O(n + m): the touching vertex is walked along, never searched.
/// Throws:     PreconditionError.
/// After:      [CF91] §3.1, Definitions 2 to 4; [P93] §4.2.3.1.
ExtremalPlanes extremal_planes(const Light& light, const ConvexPolygon& blocker);

}  // namespace gnomon
