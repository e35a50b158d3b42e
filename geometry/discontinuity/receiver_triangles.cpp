#include <map>
#include <set>
#include <utility>

#include "geometry/discontinuity/face_triangulation.h"
#include "geometry/discontinuity/receiver_mesh_data.h"

namespace gnomon {
namespace {

/// The triangulation of a face's hull, with the face's edges.
class HullTriangulation {
 public:
  HullTriangulation(const ReceiverMesh::Data& data, const MeshFace& face) : data_(data) {
    for (const auto& cycle : face.cycles) {
      for (const MeshEdgeUse use : cycle) insert(data.edges[use / 2].source), insert(data.edges[use / 2].target);
    }
    for (const auto& cycle : face.cycles) {
      for (const MeshEdgeUse use : cycle) add(data.edges[use / 2], use % 2 == 0);
    }
  }

  std::vector<event::FacePiece> pieces() {
    std::map<event::FaceTriangulation::Face_handle, std::uint32_t> inside;
    for (auto t = triangulation_.finite_faces_begin(); t != triangulation_.finite_faces_end(); ++t) {
      for (int i = 0; i < 3; ++i) {
        if (sides_.contains(event::side_of(t, i))) event::spread(t, 0, inside);
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
    found->second = triangulation_.insert(event::triangulation_point(p));
    found->second->info() = v;
  }

  void add(const MeshEdge& edge, bool forward) {
    const auto [from, to] = forward ? std::pair(edge.source, edge.target) : std::pair(edge.target, edge.source);
    // An edge inside of the face is met twice.
    if (!sides_.contains({to, from})) triangulation_.insert_constraint(handles_.at(from), handles_.at(to));
    sides_.insert({from, to});
  }

  event::FacePiece piece(event::FaceTriangulation::Face_handle triangle) const {
    event::FacePiece result;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      result.at(k) = data_.plane.spatial(data_.point(triangle->vertex(i)->info()));
    }
    return result;
  }

  const ReceiverMesh::Data& data_;
  event::FaceTriangulation triangulation_;
  std::map<std::uint32_t, event::FaceTriangulation::Vertex_handle> handles_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides_;  ///< with the face on the left
};

}  // namespace

std::vector<event::FacePiece> face_pieces(const ReceiverMesh::Data& data, const MeshFace& face) {
  return HullTriangulation(data, face).pieces();
}

}  // namespace gnomon
