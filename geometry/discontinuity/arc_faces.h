#pragma once

/// Puts the cells of divided faces into a receiver's mesh. Private to this folder.

#include <span>

#include "geometry/discontinuity/face_cells.h"
#include "geometry/discontinuity/receiver_mesh_data.h"

namespace gnomon::event {

/// A face and what it falls into.
struct FaceDivision {
  std::uint32_t face = 0;
  FaceCells cells;
  std::vector<std::uint32_t> vertices;  ///< of the mesh, of those that nodes of the cells are
  std::vector<EventName> names;         ///< of the arcs
};

/// The sides of a face, with the edges as their names, each as it is met with the face on the left.
struct FaceSides {
  std::vector<conic::Side> sides;
  std::vector<std::uint32_t> vertices;  ///< of the mesh, of those that sides number
};

/// Requires: a mesh of straight edges.
FaceSides sides_of(const ReceiverMesh::Data& data, const MeshFace& face);

/// Replaces faces by their cells: the first takes the face's place, others come after all faces. Edges at which arcs
/// end are parted there; the first part takes the edge's place.
void divide_faces(std::span<const FaceDivision> divisions, ReceiverMesh::Data& data);

}  // namespace gnomon::event
