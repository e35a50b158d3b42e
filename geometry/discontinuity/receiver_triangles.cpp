#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <map>
#include <utility>

#include "geometry/discontinuity/receiver_mesh_data.h"

namespace gnomon {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

/// The mesh face to the left of each directed edge.
using LeftFaces = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;

LeftFaces left_faces(const std::vector<MeshEdge>& edges) {
  LeftFaces left;
  for (const MeshEdge& edge : edges) {
    left[{edge.source, edge.target}] = edge.left;
    left[{edge.target, edge.source}] = edge.right;
  }
  return left;
}

/// Spreads the number of a mesh face over the triangles that no edge parts.
void spread(Triangulation::Face_handle first, std::uint32_t face,
            std::map<Triangulation::Face_handle, std::uint32_t>& of) {
  std::vector<Triangulation::Face_handle> stack{first};
  while (!stack.empty()) {
    const auto triangle = stack.back();
    stack.pop_back();
    if (!of.try_emplace(triangle, face).second) continue;
    for (int i = 0; i < 3; ++i) {
      if (!triangle->is_constrained(i)) stack.push_back(triangle->neighbor(i));
    }
  }
}

}  // namespace

std::vector<ReceiverTriangle> ReceiverMesh::triangles() const {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> handles;
  for (std::uint32_t v = 0; v < vertex_count(); ++v) {
    const event::FlatPoint p = data_->point(v);
    handles.push_back(triangulation.insert(Kernel::Point_2(Kernel::FT(p.x), Kernel::FT(p.y))));
    handles.back()->info() = v;
  }
  for (const MeshEdge& edge : edges()) triangulation.insert_constraint(handles[edge.source], handles[edge.target]);
  const LeftFaces left = left_faces(edges());
  std::map<Triangulation::Face_handle, std::uint32_t> face_of;
  for (auto t = triangulation.finite_faces_begin(); t != triangulation.finite_faces_end(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const auto found = left.find({t->vertex(Triangulation::ccw(i))->info(), t->vertex(Triangulation::cw(i))->info()});
      if (found != left.end() && found->second != MeshEdge::nowhere) spread(t, found->second, face_of);
    }
  }
  std::vector<ReceiverTriangle> result;
  for (auto t = triangulation.finite_faces_begin(); t != triangulation.finite_faces_end(); ++t) {
    const auto found = face_of.find(t);
    if (found == face_of.end()) continue;
    result.push_back({{t->vertex(0)->info(), t->vertex(1)->info(), t->vertex(2)->info()}, found->second});
  }
  return result;
}

}  // namespace gnomon
