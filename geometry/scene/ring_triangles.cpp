#include "geometry/scene/ring_triangles.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <map>
#include <utility>

namespace gnomon {
namespace {

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, InputKernel>;
/// How many rings lie around a face.
using DepthBase = CGAL::Triangulation_face_base_with_info_2<int, InputKernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<InputKernel, DepthBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<InputKernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_tag>;

constexpr int unknown_depth = -1;

Triangulation triangulation_of(const FlatRing& points, const std::vector<Ring>& rings) {
  Triangulation triangulation;
  for (const Ring& ring : rings) {
    std::vector<Triangulation::Vertex_handle> vertices;
    for (const std::uint32_t i : ring) {
      vertices.push_back(triangulation.insert(points[i]));
      vertices.back()->info() = i;
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      triangulation.insert_constraint(vertices[i], vertices[(i + 1) % ring.size()]);
    }
  }
  return triangulation;
}

using Sides = std::vector<Triangulation::Edge>;

/// Gives a face and all that no ring parts from it the same depth, and collects the sides that lead on.
void fill(Triangulation::Face_handle start, int depth, Sides& borders) {
  std::vector<Triangulation::Face_handle> reached{start};
  start->info() = depth;
  while (!reached.empty()) {
    const Triangulation::Face_handle face = reached.back();
    reached.pop_back();
    for (int side = 0; side < 3; ++side) {
      const Triangulation::Face_handle next = face->neighbor(side);
      if (next->info() != unknown_depth) continue;
      if (face->is_constrained(side)) {
        borders.emplace_back(face, side);
        continue;
      }
      next->info() = depth;
      reached.push_back(next);
    }
  }
}

/// From the outside inwards, so that nobody comes out of a ring before the outside is known.
void find_depths(Triangulation& triangulation) {
  for (const auto face : triangulation.all_face_handles()) face->info() = unknown_depth;
  Sides borders;
  fill(triangulation.infinite_face(), 0, borders);
  for (std::size_t i = 0; i < borders.size(); ++i) {
    const auto [face, side] = borders[i];
    const Triangulation::Face_handle next = face->neighbor(side);
    if (next->info() == unknown_depth) fill(next, face->info() + 1, borders);
  }
}

/// Convex polygons that grow. What was joined to another is empty.
class Joiner {
 public:
  Joiner(const FlatRing& points, std::vector<Ring> pieces) : points_(points), pieces_(std::move(pieces)) {
    for (std::size_t p = 0; p < pieces_.size(); ++p) take_edges(p);
  }

  std::vector<Ring> joined() {
    std::vector<Edge> edges;
    for (const auto& [edge, piece] : piece_at_) {
      if (edge.first < edge.second && piece_at_.contains({edge.second, edge.first})) edges.push_back(edge);
    }
    for (const Edge& edge : edges) join(edge);
    std::erase_if(pieces_, [](const Ring& piece) { return piece.empty(); });
    return std::move(pieces_);
  }

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  void take_edges(std::size_t p) {
    const Ring& ring = pieces_[p];
    for (std::size_t i = 0; i < ring.size(); ++i) piece_at_[{ring[i], ring[(i + 1) % ring.size()]}] = p;
  }

  bool turns_right(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return CGAL::orientation(points_[a], points_[b], points_[c]) == CGAL::RIGHT_TURN;
  }

  /// The ring of the piece, from the end of one of its edges round to its start.
  Ring chain_after(const Edge& edge) const {
    Ring ring = pieces_[piece_at_.at(edge)];
    std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), edge.second), ring.end());
    return ring;
  }

  void join(const Edge& edge) {
    const Edge back{edge.second, edge.first};
    const std::size_t kept = piece_at_.at(edge);
    const std::size_t other = piece_at_.at(back);
    Ring ring = chain_after(edge);         // from the edge's end to its start
    const Ring added = chain_after(back);  // from its start to its end
    if (turns_right(ring[ring.size() - 2], edge.first, added[1])) return;
    if (turns_right(added[added.size() - 2], edge.second, ring[1])) return;
    ring.insert(ring.end(), added.begin() + 1, added.end() - 1);
    pieces_[other].clear();
    pieces_[kept] = std::move(ring);
    take_edges(kept);
  }

  const FlatRing& points_;
  std::vector<Ring> pieces_;
  std::map<Edge, std::size_t> piece_at_;
};

}  // namespace

std::vector<Ring> ring_triangles(const FlatRing& points, const std::vector<Ring>& rings) {
  Triangulation triangulation = triangulation_of(points, rings);
  find_depths(triangulation);
  std::vector<Ring> triangles;
  for (const auto face : triangulation.finite_face_handles()) {
    if (face->info() != 1) continue;
    triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  return triangles;
}

std::vector<Ring> joined_triangles(const FlatRing& points, std::vector<Ring> triangles) {
  return Joiner(points, std::move(triangles)).joined();
}

}  // namespace gnomon
