#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/numbers/exact_vector.h"

namespace gnomon {

/// A closed surface of triangles with exact vertices.
struct ExactTriangles {
  struct Triangle {
    std::array<std::uint32_t, 3> vertices;  ///< counterclockwise seen from outside
    std::uint32_t facet;
  };
  std::vector<ExactVector> points;
  std::vector<Triangle> triangles;
};

/// Gives each sheet of a surface that touches itself vertices of its own, so that every edge is in two triangles.
///
/// Definition: triangles round an edge belong together if the volume lies between them. A vertex gets a copy for every
///             fan of triangles that belong together; an edge that still has two sheets is divided, in each at a vertex
///             of its own in the middle.
/// Requires:   the boundary of a volume: round every edge triangles that run one way and the other take turns.
/// Cost:       O(n log n) for n triangles.
ExactTriangles with_sheets_apart(ExactTriangles surface);

}  // namespace gnomon
