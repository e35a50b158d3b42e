#include "apps/proof/laws/subject.h"

namespace gnomon::laws {

DividedReceiver divided_receiver(const Light& light, const std::vector<ConvexBlocker>& blockers,
                                 const ConvexPolygon& receiver) {
  const ReceiverMesh mesh = receiver_division(light, blockers, std::vector{receiver}).front();
  DividedReceiver result{mesh.vertices(), mesh.edges(), {}, mesh.names(), mesh.triangles()};
  for (const MeshFace& face : mesh.faces()) result.faces.push_back(face.region);
  return result;
}

}  // namespace gnomon::laws
