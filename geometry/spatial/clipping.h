#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/spatial/convex_polyhedron.h"

namespace gnomon {

/// A half-space by which a polyhedron is to be cut.
struct Cut {
  PlaneId plane;
  std::optional<VertexId> outside;  ///< a vertex of the polyhedron known to lie strictly outside; else one is sought
  bool first = false;               ///< cut with before all that are not: it takes away where many others meet
};

/// The part of a polyhedron inside every plane; empty if that has no interior. Faces keep their planes; every plane
/// that bounds the result has one face.
///
/// Definition: the planes are cut with in an order that is fixed but mixed. Each plane still to come knows one vertex
///             outside of it, found again on the new face when it is cut away; where there is none the plane is
///             redundant, because the vertices outside a plane are connected by edges.
/// Exactness:  signs of ExactSpace::side alone.
/// Cost:       one scan of the polyhedron for every plane without a known vertex, then O(k log k) expected for k planes
///             whose faces are small on average.
/// After:      [CS89] for the order and the vertices remembered; [Chew86] where every plane goes through an edge of a
///             convex polygon.
/// `last` are cut with at the end, in their order, each after a scan: planes that take most of an unbounded polyhedron
/// away, as those of a box do.
ConvexPolyhedron clipped(ExactSpace& space, const ConvexPolyhedron& polyhedron, std::vector<Cut> cuts,
                         std::span<const PlaneId> last = {});

/// The part inside one plane.
ConvexPolyhedron clipped(ExactSpace& space, const ConvexPolyhedron& polyhedron, PlaneId plane);

}  // namespace gnomon
