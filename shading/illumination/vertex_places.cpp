#include "shading/illumination/vertex_places.h"

#include "geometry/discontinuity/receiver_mesh_data.h"

namespace gnomon::illumination {

VertexPlaces::VertexPlaces(const ReceiverMesh& mesh) : mesh_(mesh), along_(mesh.data().vertex_count()) {
  for (const MeshEdge& edge : mesh.edges()) {
    if (edge.arc != MeshEdge::nowhere) continue;
    if (!mesh.data().is_rational(edge.source)) along_[edge.source].push_back(edge.target);
    if (!mesh.data().is_rational(edge.target)) along_[edge.target].push_back(edge.source);
  }
}

ExactVector VertexPlaces::known(std::uint32_t vertex) const {
  return mesh_.data().plane.spatial(mesh_.data().point(vertex));
}

/// Lines that cross do so at rational places, so all straight edges at another place are on one line: it is followed to
/// where it is rational.
std::uint32_t VertexPlaces::end_beyond(std::uint32_t from, std::uint32_t to) const {
  while (along_[to].size() == 2) {
    const std::uint32_t next = along_[to][along_[to][0] == from ? 1 : 0];
    from = to;
    to = next;
  }
  return to;
}

ExactVector VertexPlaces::at(std::uint32_t vertex) const {
  const std::vector<std::uint32_t>& next = along_[vertex];
  const ExactVector place = known(vertex);
  if (next.size() != 2) return place;
  const ExactVector a = known(end_beyond(vertex, next[0])), b = known(end_beyond(vertex, next[1]));
  const ExactVector along = b - a;
  return a + Rational(dot(place - a, along) / dot(along, along)) * along;
}

}  // namespace gnomon::illumination
