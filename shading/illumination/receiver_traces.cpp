#include "shading/illumination/receiver_traces.h"

#include <algorithm>

#include "shading/illumination/vertex_places.h"

namespace gnomon::illumination {
namespace {

Point3 middle_of(const Point3& a, const Point3& b, const Point3& c) {
  return {a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3, a.z / 3 + b.z / 3 + c.z / 3};
}

}  // namespace

// Where the light shows its edge irradiance has limits as if something touched the receiver.
std::uint8_t order_of(const ReceiverMesh& mesh, const MeshEdge& edge) {
  std::uint8_t order = smooth;
  for (const std::uint32_t n : edge.names) {
    const EventName& name = mesh.names()[n];
    if (name.kind == EventKind::border) continue;
    order = std::min(order, name.kind == EventKind::light_plane ? std::uint8_t{0} : name.order);
  }
  return order;
}

ReceiverTraces traces_of(const ReceiverMesh& mesh) {
  ReceiverTraces found;
  const MeshDrawing drawing = mesh.drawing();
  const VertexPlaces places(mesh);
  for (std::size_t e = 0; e < mesh.edges().size(); ++e) {
    const MeshEdge& edge = mesh.edges()[e];
    const std::uint8_t order = order_of(mesh, edge);
    if (order == smooth) continue;
    // Chords end in the vertices themselves, or slivers as thin as rounding would part them from what ends there.
    const std::vector<std::uint32_t>& line = drawing.lines[e];
    ExactVector from = places.at(edge.source);
    for (std::size_t k = 1; k < line.size(); ++k) {
      const ExactVector to = k + 1 < line.size() ? exact(drawing.points[line[k]]) : places.at(edge.target);
      found.traces.push_back({from, to, order});
      from = to;
    }
  }
  for (const ReceiverTriangle& t : drawing.triangles) {
    const auto& [a, b, c] = t.vertices;
    found.inside.push_back(middle_of(drawing.points[a], drawing.points[b], drawing.points[c]));
  }
  return found;
}

}  // namespace gnomon::illumination
