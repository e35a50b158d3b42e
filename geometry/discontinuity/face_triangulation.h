#pragma once

/// Triangulations of faces between their edges. Private to this folder; a heavy header.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "geometry/numbers/flat_point.h"

namespace gnomon::event {

using TriangulationKernel = CGAL::Exact_predicates_exact_constructions_kernel;

/// Its vertices bear the numbers of points. An edge that crosses another is refused by an exception.
using FaceTriangulation = CGAL::Constrained_Delaunay_triangulation_2<
    TriangulationKernel,
    CGAL::Triangulation_data_structure_2<
        CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, TriangulationKernel>,
        CGAL::Constrained_triangulation_face_base_2<TriangulationKernel>>,
    CGAL::No_constraint_intersection_tag>;

inline TriangulationKernel::Point_2 triangulation_point(const FlatPoint& p) {
  return {TriangulationKernel::FT(p.x), TriangulationKernel::FT(p.y)};
}

/// The numbers of the ends of a triangle's side, with the triangle on the left.
inline std::pair<std::uint32_t, std::uint32_t> side_of(FaceTriangulation::Face_handle triangle, int i) {
  return {triangle->vertex(FaceTriangulation::ccw(i))->info(), triangle->vertex(FaceTriangulation::cw(i))->info()};
}

/// Gives the triangles that no edge parts from this one the same number.
inline void spread(FaceTriangulation::Face_handle first, std::uint32_t number,
                   std::map<FaceTriangulation::Face_handle, std::uint32_t>& of) {
  std::vector<FaceTriangulation::Face_handle> stack{first};
  while (!stack.empty()) {
    const auto triangle = stack.back();
    stack.pop_back();
    if (!of.try_emplace(triangle, number).second) continue;
    for (int i = 0; i < 3; ++i) {
      if (!triangle->is_constrained(i)) stack.push_back(triangle->neighbor(i));
    }
  }
}

}  // namespace gnomon::event
