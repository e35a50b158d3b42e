#pragma once

/// What a ReceiverMesh consists of. Private to this folder and to tests.

#include "geometry/discontinuity/receiver_arrangement.h"
#include "geometry/discontinuity/receiver_plane.h"
#include "geometry/discontinuity/region_change.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon {

struct ReceiverMesh::Data {
  event::ReceiverPlane plane;
  event::ReceiverArrangement arrangement;
  std::vector<MeshEdge> edges;
  std::vector<MeshFace> faces;
  std::vector<EventName> names;

  event::FlatPoint point(std::uint32_t vertex) const { return arrangement.point(vertex); }
};

/// Twice the area of faces seen along the axis that the receiver's plane drops.
Rational doubled_flat_area(const ReceiverMesh::Data& data, std::span<const std::vector<MeshEdgeUse>> cycles);

/// A face as triangles between its vertices. Exactness: exact.
std::vector<event::FacePiece> face_pieces(const ReceiverMesh::Data& data, const MeshFace& face);

}  // namespace gnomon
