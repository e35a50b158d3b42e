#pragma once

#include <vector>

#include <boost/container/small_vector.hpp>

#include "geometry/spatial/exact_space.h"

namespace gnomon {

/// Vertices around a polygon; most have few.
using Loop = boost::container::small_vector<VertexId, 8>;

/// A convex polyhedron, possibly unbounded: its corners include points at infinity, and then one face lies there.
struct ConvexPolyhedron {
  struct Face {
    PlaneId plane;
    Loop loop;  ///< strictly convex, counterclockwise seen from outside
  };
  std::vector<Face> faces;  ///< empty: no interior

  bool empty() const { return faces.empty(); }
};

}  // namespace gnomon
