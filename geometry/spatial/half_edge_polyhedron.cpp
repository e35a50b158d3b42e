#include "geometry/spatial/half_edge_polyhedron.h"

#include <algorithm>
#include <utility>

namespace gnomon {

HalfEdgePolyhedron::HalfEdgePolyhedron(ExactSpace& space, const ConvexPolyhedron& polyhedron) : space_(space) {
  std::size_t corners = 0;
  for (const auto& face : polyhedron.faces) corners += face.loop.size();
  edges_.reserve(3 * corners + 64);
  vertices_.reserve(corners + 32);
  faces_.reserve(2 * polyhedron.faces.size() + 8);
  for (const auto& face : polyhedron.faces) {
    const auto first = static_cast<Index>(edges_.size());
    const auto size = static_cast<Index>(face.loop.size());
    for (Index i = 0; i < size; ++i) {
      edges_.push_back({face.loop[i], first + (i + 1) % size, first + (i + size - 1) % size, none,
                        static_cast<Index>(faces_.size())});
    }
    faces_.push_back({face.plane, first});
  }
  number_vertices();
  link_twins();
  empty_ = polyhedron.empty();
}

/// Numbers the vertices in the order of their names.
void HalfEdgePolyhedron::number_vertices() {
  boost::container::small_vector<Index, 128> index(space_.vertex_count(), none);
  for (Index e = 0; e < edges_.size(); ++e) index[edges_[e].origin] = e;
  for (VertexId id = 0; id < index.size(); ++id) {
    if (index[id] == none) continue;
    vertices_.push_back({id, index[id]});
    index[id] = static_cast<Index>(vertices_.size() - 1);
  }
  for (HalfEdge& edge : edges_) edge.origin = index[edge.origin];
}

/// Finds for every half-edge the one that runs the other way, among those with the same lower end.
void HalfEdgePolyhedron::link_twins() {
  boost::container::small_vector<Index, 64> first(vertices_.size(), none);  // of the half-edges with this lower end
  boost::container::small_vector<Index, 128> following(edges_.size());
  const auto ends = [&](Index e) { return std::minmax(edges_[e].origin, edges_[edges_[e].next].origin); };
  for (Index e = 0; e < edges_.size(); ++e) following[e] = std::exchange(first[ends(e).first], e);
  boost::container::small_vector<Index, 64> other(vertices_.size(),
                                                  none);  // the half-edge last seen with this upper end
  for (const Index start : first) {
    for (Index e = start; e != none; e = following[e]) {
      const Index match = std::exchange(other[ends(e).second], e);
      if (match == none || ends(match).first != ends(e).first) continue;
      edges_[e].twin = match;
      edges_[match].twin = e;
    }
  }
}

HalfEdgePolyhedron::Index HalfEdgePolyhedron::index_of(VertexId id) const {
  const auto before = [](const Vertex& vertex, VertexId wanted) { return vertex.id < wanted; };
  return static_cast<Index>(std::lower_bound(vertices_.begin(), vertices_.end(), id, before) - vertices_.begin());
}

std::optional<HalfEdgePolyhedron::Index> HalfEdgePolyhedron::vertex_outside(PlaneId plane) const {
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (is_alive(v) && space_.side(plane, vertices_[v].id) > 0) return v;
  }
  return std::nullopt;
}

int HalfEdgePolyhedron::sign(Index vertex) {
  Vertex& v = vertices_[vertex];
  if (v.stamp != stamp_) {
    v.stamp = stamp_;
    v.sign = space_.side(plane_, v.id);
    v.on_cut = none;
  }
  return v.sign;
}

/// Collects the vertices outside, the edges that leave them, and the faces they touch.
void HalfEdgePolyhedron::find_outside(Index start) {
  sign(start);
  removed_.assign(1, start);
  vertices_[start].on_cut = start;  // marks it as collected
  for (std::size_t i = 0; i < removed_.size(); ++i) {
    const Index first = vertices_[removed_[i]].out;
    Index e = first;
    do {
      Face& face = faces_[edges_[e].face];
      if (face.stamp != stamp_) {
        face.stamp = stamp_;
        face.survives = false;
        touched_faces_.push_back(edges_[e].face);
      }
      const Index u = destination(e);
      const int side = sign(u);
      if (side <= 0) {
        exits_.push_back({e, u, side == 0});
      } else if (vertices_[u].on_cut == none) {
        vertices_[u].on_cut = u;
        removed_.push_back(u);
      }
      e = edges_[edges_[e].previous].twin;
    } while (e != first);
  }
}

/// True if a vertex lies strictly inside the plane: if so, one is next to the vertices outside or to one on the plane.
bool HalfEdgePolyhedron::has_inside() {
  for (const Exit& exit : exits_) {
    if (!exit.on_plane) return true;
  }
  for (const Exit& exit : exits_) {
    const Index first = vertices_[exit.point].out;
    Index e = first;
    do {
      if (sign(destination(e)) < 0) return true;
      e = edges_[edges_[e].previous].twin;
    } while (e != first);
  }
  return false;
}

/// Cuts the edges that cross the plane: the part inside keeps the half-edges.
void HalfEdgePolyhedron::make_points() {
  for (Exit& exit : exits_) {
    const Index twin = edges_[exit.edge].twin;
    faces_[edges_[twin].face].entry = twin;
    if (exit.on_plane) continue;
    const VertexId id = space_.add_cut(vertices_[edges_[exit.edge].origin].id, vertices_[exit.point].id,
                                       faces_[edges_[exit.edge].face].plane, faces_[edges_[twin].face].plane, plane_);
    exit.point = static_cast<Index>(vertices_.size());
    vertices_.push_back({id, exit.edge, 0, stamp_, none});
    edges_[exit.edge].origin = exit.point;
  }
}

/// Gives a face its new edge along the plane, from where its boundary enters what is cut away to where it leaves it.
/// A face of which nothing but an edge or a point on the plane is left goes.
void HalfEdgePolyhedron::close_face(const Exit& exit, Index cap) {
  const Index face = edges_[exit.edge].face;
  const Index entry = faces_[face].entry;
  const Index after_entry = edges_[edges_[entry].twin].origin;  // the point on the entry's edge, if that was cut
  const bool entry_on_plane = sign(edges_[entry].origin) == 0;
  const Index start = entry_on_plane ? edges_[entry].origin : after_entry;
  const Index first = exit.on_plane ? edges_[exit.edge].next : exit.edge;
  const Index last = entry_on_plane ? edges_[entry].previous : entry;
  if (exit.on_plane && entry_on_plane) {
    if (start == exit.point) return;
    if (first == last) {
      edges_[first].face = cap;
      cap_edges_.push_back(first);
      return;
    }
  }
  const auto inner = static_cast<Index>(edges_.size());
  const Index outer = inner + 1;
  edges_.push_back({start, first, last, outer, face});
  edges_.push_back({exit.point, none, none, inner, cap});
  edges_[first].previous = inner;
  edges_[last].next = inner;
  faces_[face].edge = inner;
  faces_[face].survives = true;
  cap_edges_.push_back(outer);
}

/// Links the edges of the new face to a loop.
void HalfEdgePolyhedron::close_cap(Index cap) {
  for (const Index e : cap_edges_) {
    const Index origin = edges_[e].origin;
    vertices_[origin].on_cut = e;
    vertices_[origin].out = e;
    boundary_.push_back(origin);
  }
  for (const Index e : cap_edges_) {
    const Index next = vertices_[destination(e)].on_cut;
    edges_[e].next = next;
    edges_[next].previous = e;
  }
  faces_[cap].edge = cap_edges_.front();
}

void HalfEdgePolyhedron::cut(PlaneId plane, Index outside) {
  plane_ = plane;
  ++stamp_;
  touched_faces_.clear();
  exits_.clear();
  cap_edges_.clear();
  boundary_.clear();
  find_outside(outside);
  empty_ = !has_inside();
  if (empty_) return;
  make_points();
  const auto cap = static_cast<Index>(faces_.size());
  faces_.push_back({plane, none});
  for (const Exit& exit : exits_) close_face(exit, cap);
  close_cap(cap);
  for (const Index f : touched_faces_) {
    if (!faces_[f].survives) faces_[f].edge = none;
  }
  for (const Index v : removed_) vertices_[v].out = none;
}

ConvexPolyhedron HalfEdgePolyhedron::polyhedron() const {
  ConvexPolyhedron result;
  if (empty_) return result;
  result.faces.reserve(faces_.size());
  for (const Face& face : faces_) {
    if (face.edge == none) continue;
    ConvexPolyhedron::Face& kept = result.faces.emplace_back(ConvexPolyhedron::Face{face.plane, {}});
    Index e = face.edge;
    do {
      kept.loop.push_back(vertices_[edges_[e].origin].id);
      e = edges_[e].next;
    } while (e != face.edge);
  }
  return result;
}

}  // namespace gnomon
