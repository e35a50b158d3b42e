#pragma once

#include <array>
#include <vector>

#include "geometry/spatial/clipping.h"
#include "geometry/spatial/convex_polyhedron.h"
#include "geometry/spatial/pair_half_spaces.h"

namespace gnomon {

/// The half-spaces of a pair as planes of an exact space; planes that bound both volumes are one.
///
/// Requires: the rounding mode is protected while it is made and used.
struct ShadowPlanes {
  /// `downward` is the first plane of the space, see ExactSpace: a facet of the blocker. A half-space of the same name
  /// is the same.
  ShadowPlanes(const PairHalfSpaces& half_spaces, const HalfSpace& downward);

  ExactSpace space;
  std::vector<PlaneId> occlusion;  ///< one for every half-space, in their order
  std::vector<PlaneId> umbra;
};

/// The six planes of a box, in the order of FacetName's sides.
std::array<PlaneId, 6> add_box(ExactSpace& space, const Box3& box);

/// The whole box. Requires: `sides` are its six planes in order.
ConvexPolyhedron box_polyhedron(ExactSpace& space, const Box3& box, const std::array<PlaneId, 6>& sides);

/// The part of a polyhedron in the intersection of half-spaces.
ConvexPolyhedron part_inside(ExactSpace& space, const ConvexPolyhedron& polyhedron, const std::vector<PlaneId>& planes);

/// The part of a polyhedron outside an intersection of half-spaces as convex cells: each lies outside one of the planes
/// and inside all before it; cells without interior are left out.
std::vector<ConvexPolyhedron> cells_outside(ExactSpace& space, ConvexPolyhedron polyhedron,
                                            const std::vector<PlaneId>& planes);

}  // namespace gnomon
