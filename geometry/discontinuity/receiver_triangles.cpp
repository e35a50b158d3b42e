#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <map>
#include <set>
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

/// The triangulation of a face's hull, with the face's edges.
class FaceTriangulation {
 public:
  FaceTriangulation(const ReceiverMesh::Data& data, const MeshFace& face) : data_(data) {
    for (const auto& cycle : face.cycles) {
      for (const MeshEdgeUse use : cycle) insert(data.edges[use / 2].source), insert(data.edges[use / 2].target);
    }
    for (const auto& cycle : face.cycles) {
      for (const MeshEdgeUse use : cycle) add(data.edges[use / 2], use % 2 == 0);
    }
  }

  std::vector<event::FacePiece> pieces() {
    std::map<Triangulation::Face_handle, std::uint32_t> inside;
    for (auto t = triangulation_.finite_faces_begin(); t != triangulation_.finite_faces_end(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const std::pair side{t->vertex(Triangulation::ccw(i))->info(), t->vertex(Triangulation::cw(i))->info()};
        if (sides_.contains(side)) spread(t, 0, inside);
      }
    }
    std::vector<event::FacePiece> result;
    for (const auto& [triangle, face] : inside) result.push_back(piece(triangle));
    return result;
  }

 private:
  void insert(std::uint32_t v) {
    const auto [found, is_new] = handles_.try_emplace(v);
    if (!is_new) return;
    const event::FlatPoint p = data_.point(v);
    found->second = triangulation_.insert(Kernel::Point_2(Kernel::FT(p.x), Kernel::FT(p.y)));
    found->second->info() = v;
  }

  void add(const MeshEdge& edge, bool forward) {
    const auto [from, to] = forward ? std::pair(edge.source, edge.target) : std::pair(edge.target, edge.source);
    // An edge inside of the face is met twice.
    if (!sides_.contains({to, from})) triangulation_.insert_constraint(handles_.at(from), handles_.at(to));
    sides_.insert({from, to});
  }

  event::FacePiece piece(Triangulation::Face_handle triangle) const {
    event::FacePiece result;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      result.corners[k] = data_.plane.spatial(data_.point(triangle->vertex(i)->info()));
      result.is_border[k] = triangle->is_constrained(Triangulation::cw(i));
    }
    return result;
  }

  const ReceiverMesh::Data& data_;
  Triangulation triangulation_;
  std::map<std::uint32_t, Triangulation::Vertex_handle> handles_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides_;  ///< with the face on the left
};

}  // namespace

std::vector<event::FacePiece> face_pieces(const ReceiverMesh::Data& data, const MeshFace& face) {
  return FaceTriangulation(data, face).pieces();
}

}  // namespace gnomon
