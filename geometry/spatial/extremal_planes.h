#pragma once

#include <vector>

#include "geometry/contact.h"
#include "geometry/indices.h"
#include "geometry/spatial/light.h"

namespace gnomon {

/// The plane through a blocker edge that touches the light, named by input elements alone.
struct BlockerPlane {
  BlockerEdge edge;
  LightVertex vertex;

  friend bool operator==(const BlockerPlane&, const BlockerPlane&) = default;
};

/// The plane through a light edge (or the whole linear light) that touches the blocker.
struct LightPlane {
  LightEdge edge;
  BlockerVertex vertex;

  friend bool operator==(const LightPlane&, const LightPlane&) = default;
};

/// All extremal planes of one light and one flat blocker, in the order of the blocker's (the light's) sides.
///
/// Each plane is listed once with each contact it has: a plane through a blocker edge that holds the whole light (a
/// point light, a linear light coplanar with the edge) is separating and supporting. Where a light edge and a blocker
/// edge are coplanar, the blocker edge is named; where several vertices touch, the one of lowest index; where a side
/// consists of several collinear edges, the edge of lowest index.
struct ExtremalPlanes {
  std::vector<BlockerPlane> separating_blocker;  ///< one per side of the blocker
  std::vector<LightPlane> separating_light;      ///< through light edges, those coplanar with a blocker edge left out
  std::vector<BlockerPlane> supporting_blocker;  ///< one per side of the blocker
};

/// The extremal planes of a pair in standard position.
///
/// Requires:   pair_position(light, blocker) == Position::standard.
/// Exactness:  signs of orientation determinants of input points; nothing is constructed.
/// Cost:       O(n + m): the touching vertex is walked along, never searched.
/// Throws:     PreconditionError.
/// After:      [CF91] §3.1, Definitions 2 to 4; [P93] §4.2.3.1.
ExtremalPlanes extremal_planes(const Light& light, const ConvexPolygon& blocker);

}  // namespace gnomon
