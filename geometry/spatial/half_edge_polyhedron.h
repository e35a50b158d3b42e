#pragma once

#include <optional>
#include <vector>

#include "geometry/spatial/convex_polyhedron.h"

namespace gnomon {

/// A convex polyhedron as half-edges, for cutting: what a plane does not touch is not visited.
///
/// Vertices are counted here from 0 in the order of their appearance; `id` tells their names in the space.
class HalfEdgePolyhedron {
 public:
  using Index = std::uint32_t;
  using Indices = boost::container::small_vector<Index, 32>;
  static constexpr Index none = ~0u;

  HalfEdgePolyhedron(ExactSpace& space, const ConvexPolyhedron& polyhedron);

  /// Cuts the outside of a plane away. Afterwards `removed` and `boundary` tell what happened.
  ///
  /// Requires: `outside` is a vertex strictly outside the plane.
  void cut(PlaneId plane, Index outside);

  /// A vertex strictly outside the plane, found by looking at every vertex.
  std::optional<Index> vertex_outside(PlaneId plane) const;

  bool empty() const { return empty_; }
  Index vertex_count() const { return static_cast<Index>(vertices_.size()); }
  bool is_alive(Index vertex) const { return vertices_[vertex].out != none; }
  VertexId id(Index vertex) const { return vertices_[vertex].id; }
  /// Requires: a vertex of the polyhedron this was made from.
  Index index_of(VertexId id) const;

  /// The vertices that the last cut took away, and those of the face that it made.
  const Indices& removed() const { return removed_; }
  const Indices& boundary() const { return boundary_; }

  ConvexPolyhedron polyhedron() const;

 private:
  struct HalfEdge {
    Index origin, next, previous, twin, face;
  };
  struct Vertex {
    VertexId id;
    Index out;  ///< a half-edge that starts here, or none: the vertex is gone
    int sign = 0;
    Index stamp = 0;
    Index on_cut = none;  ///< the half-edge of the new face that starts here
  };
  struct Face {
    PlaneId plane;
    Index edge;  ///< or none: the face is gone
    Index stamp = 0;
    Index entry = none;  ///< the half-edge that leads into what is cut away
    bool survives = false;
  };
  /// An edge that leaves what is cut away, and the point in which the new face begins there.
  struct Exit {
    Index edge;
    Index point;
    bool on_plane;
  };

  Index destination(Index edge) const { return edges_[edges_[edge].twin].origin; }
  int sign(Index vertex);
  void find_outside(Index start);
  bool has_inside();
  void make_points();
  void close_face(const Exit& exit, Index cap);
  void close_cap(Index cap);
  void number_vertices();
  void link_twins();

  ExactSpace& space_;
  boost::container::small_vector<HalfEdge, 192> edges_;
  boost::container::small_vector<Vertex, 72> vertices_;
  boost::container::small_vector<Face, 32> faces_;
  bool empty_ = false;

  PlaneId plane_ = 0;
  Index stamp_ = 0;
  Indices removed_;
  Indices touched_faces_;
  boost::container::small_vector<Exit, 32> exits_;
  Indices cap_edges_;
  Indices boundary_;
};

}  // namespace gnomon
