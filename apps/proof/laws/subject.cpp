#include "apps/proof/laws/subject.h"

#include <algorithm>
#include <utility>

namespace gnomon::laws {

DividedReceiver divided_receiver(const Light& light, const std::vector<ConvexBlocker>& blockers,
                                 const ConvexPolygon& receiver) {
  const ReceiverMesh mesh = receiver_division(light, blockers, std::vector{receiver}).front();
  MeshDrawing drawing = mesh.drawing();
  // Triangles of a face with an arc may reach a little beyond it.
  std::erase_if(drawing.triangles, [&](const ReceiverTriangle& t) {
    return std::ranges::any_of(mesh.edges(), [&](const MeshEdge& edge) {
      return edge.arc != MeshEdge::nowhere && (edge.left == t.face || edge.right == t.face);
    });
  });
  DividedReceiver result{std::move(drawing.points),    mesh.edges(), {}, mesh.names(),
                         std::move(drawing.triangles), mesh.arcs()};
  for (const MeshFace& face : mesh.faces()) result.faces.push_back(face.region);
  return result;
}

}  // namespace gnomon::laws
