#pragma once

/// What a ReceiverMesh consists of. Private to this folder and to tests.

#include "geometry/conics/arc_area.h"
#include "geometry/discontinuity/closing_arcs.h"
#include "geometry/discontinuity/receiver_arrangement.h"
#include "geometry/discontinuity/receiver_plane.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon {

/// An end of an arc.
struct ArcPoint {
  conic::FlatCurve curve;
  RealRoot root;
  event::FlatPoint near;  ///< the point, if it is rational; else one within 2^-100 of it, as a share of its coordinates
  bool is_rational = false;
};

/// An arc between two faces, as its parameter grows from the edge's source to its target.
struct FaceArc {
  conic::FlatCurve curve;
  RealRoot from;
  RealRoot to;
};

struct ReceiverMesh::Data {
  event::ReceiverPlane plane;
  event::ReceiverArrangement arrangement;  ///< by straight lines alone
  std::vector<MeshEdge> edges;
  std::vector<MeshFace> faces;
  std::vector<EventName> names;
  std::vector<ArcPoint> arc_points;  ///< vertices after those of the arrangement
  std::vector<FaceArc> arcs;         ///< of edges

  std::size_t vertex_count() const { return arrangement.vertex_count() + arc_points.size(); }
  bool is_rational(std::uint32_t vertex) const {
    return vertex < arrangement.vertex_count() || arc_point(vertex).is_rational;
  }
  const ArcPoint& arc_point(std::uint32_t vertex) const { return arc_points[vertex - arrangement.vertex_count()]; }
  /// Exact, but of an irrational vertex close to it.
  event::FlatPoint point(std::uint32_t vertex) const {
    return vertex < arrangement.vertex_count() ? arrangement.point(vertex) : arc_point(vertex).near;
  }
  conic::PointBox point_box(std::uint32_t vertex, unsigned bits) const;
};

/// Twice an area seen along the axis that the receiver's plane drops: what rational numbers tell of it, and the rest.
struct FlatArea {
  Rational exact = 0;
  RationalInterval rest;
  bool is_exact = true;  ///< there is no rest

  RationalInterval sum() const { return RationalInterval(exact) + rest; }
};

/// Twice the flat area of cycles, with faces on their left. Error: the rest is known to about 2^-bits.
FlatArea doubled_flat_area(const ReceiverMesh::Data& data, std::span<const std::vector<MeshEdgeUse>> cycles,
                           unsigned bits);

/// Of the boundary cycles of a connected region only the outer one runs counterclockwise.
void put_outer_cycle_first(const ReceiverMesh::Data& data, std::vector<std::vector<MeshEdgeUse>>& cycles);

/// A face as triangles between its vertices. Requires: straight edges. Exactness: exact.
std::vector<event::FacePiece> face_pieces(const ReceiverMesh::Data& data, const MeshFace& face);

}  // namespace gnomon
