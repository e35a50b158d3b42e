#include "geometry/spatial/difference_surface.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "geometry/spatial/split_fans.h"

namespace gnomon {
namespace {

using Face = ConvexPolyhedron::Face;

/// Faces of the outer polyhedron, by their index.
using FaceIndices = std::set<std::size_t>;

std::vector<VertexId> vertices_of(const ConvexPolyhedron& polyhedron) {
  std::vector<VertexId> vertices;
  for (const Face& face : polyhedron.faces) vertices.insert(vertices.end(), face.loop.begin(), face.loop.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

void sort_by_place(const ExactSpace& space, std::vector<VertexId>& vertices) {
  std::sort(vertices.begin(), vertices.end(), [&](VertexId a, VertexId b) { return space.compare(a, b) < 0; });
}

/// The inner polyhedron with every vertex that is also one of the outer replaced by that one.
ConvexPolyhedron with_shared_vertices(const ExactSpace& space, ConvexPolyhedron inner,
                                      const std::vector<VertexId>& outer_vertices) {
  std::unordered_map<VertexId, VertexId> known;
  const auto shared = [&](VertexId v) {
    const auto [entry, is_new] = known.try_emplace(v, v);
    if (!is_new) return entry->second;
    const auto at = std::lower_bound(outer_vertices.begin(), outer_vertices.end(), v,
                                     [&](VertexId a, VertexId b) { return space.compare(a, b) < 0; });
    if (at != outer_vertices.end() && space.compare(*at, v) == 0) entry->second = *at;
    return entry->second;
  };
  for (Face& face : inner.faces) std::transform(face.loop.begin(), face.loop.end(), face.loop.begin(), shared);
  return inner;
}

/// How the inner polyhedron touches the boundary of the outer one.
struct Touching {
  std::map<VertexId, FaceIndices> faces_of_vertex;  ///< outer faces in whose planes an inner vertex lies
  std::map<std::size_t, Loop> on_face;  ///< for an outer face the face, edge or vertex of the inner one in its plane
  std::vector<bool> is_flush;           ///< for each inner face: it lies in an outer one
};

Touching touching(const ExactSpace& space, const ConvexPolyhedron& outer, const ConvexPolyhedron& inner) {
  Touching result;
  for (const VertexId v : vertices_of(inner)) {
    FaceIndices& faces = result.faces_of_vertex[v];
    for (std::size_t f = 0; f < outer.faces.size(); ++f) {
      if (space.side(outer.faces[f].plane, v) != 0) continue;
      faces.insert(f);
      result.on_face[f].push_back(v);
    }
  }
  for (const Face& face : inner.faces) {
    FaceIndices common = result.faces_of_vertex[face.loop[0]];
    for (std::size_t i = 1; i < 3; ++i) {
      const FaceIndices& others = result.faces_of_vertex[face.loop[i]];
      std::erase_if(common, [&](std::size_t f) { return !others.count(f); });
    }
    result.is_flush.push_back(!common.empty());
    if (!common.empty()) result.on_face[*common.begin()] = face.loop;
  }
  return result;
}

/// An edge of the outer polyhedron by the two faces that meet in it.
using EdgeName = std::array<std::size_t, 2>;

EdgeName edge_name(std::size_t a, std::size_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// For each edge of the outer polyhedron the inner vertices strictly inside it, in lexicographic order.
using EdgeVertices = std::map<EdgeName, std::vector<VertexId>>;

EdgeVertices inner_vertices_on_edges(const ExactSpace& space, const Touching& touching,
                                     const std::vector<VertexId>& outer_vertices) {
  const std::set<VertexId> corners(outer_vertices.begin(), outer_vertices.end());
  EdgeVertices result;
  for (const auto& [vertex, faces] : touching.faces_of_vertex) {
    if (corners.count(vertex) || faces.size() != 2) continue;
    result[edge_name(*faces.begin(), *faces.rbegin())].push_back(vertex);
  }
  for (auto& [edge, vertices] : result) sort_by_place(space, vertices);
  return result;
}

/// The face on the other side of each edge of a face.
using Neighbours = std::map<std::array<VertexId, 2>, std::size_t>;

Neighbours neighbours(const ConvexPolyhedron& polyhedron) {
  Neighbours result;
  for (std::size_t f = 0; f < polyhedron.faces.size(); ++f) {
    const Loop& loop = polyhedron.faces[f].loop;
    for (std::size_t i = 0; i < loop.size(); ++i) result[{loop[i], loop[(i + 1) % loop.size()]}] = f;
  }
  return result;
}

/// A face's loop with the inner vertices put into its edges.
Loop refined_loop(const ExactSpace& space, const ConvexPolyhedron& outer, std::size_t face, const Neighbours& next_to,
                  const EdgeVertices& edge_vertices) {
  Loop loop;
  VertexId u = outer.faces[face].loop.back();
  for (const VertexId v : outer.faces[face].loop) {
    const auto entry = edge_vertices.find(edge_name(face, next_to.at({v, u})));
    if (entry != edge_vertices.end()) {
      std::vector<VertexId> inside = entry->second;
      if (space.compare(u, v) > 0) std::reverse(inside.begin(), inside.end());
      loop.insert(loop.end(), inside.begin(), inside.end());
    }
    loop.push_back(v);
    u = v;
  }
  return loop;
}

Triangles turned(Triangles triangles) {
  for (auto& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

}  // namespace

ExactSurface surface(const ConvexPolyhedron& polyhedron) {
  ExactSurface result;
  result.facets.reserve(polyhedron.faces.size());
  for (const Face& face : polyhedron.faces) {
    Triangles& triangles = result.facets.emplace_back(ExactSurface::Facet{face.plane, {}}).triangles;
    triangles.reserve(face.loop.size() - 2);
    for (std::size_t i = 1; i + 1 < face.loop.size(); ++i) {
      triangles.push_back({face.loop[0], face.loop[i], face.loop[i + 1]});
    }
  }
  return result;
}

ExactSurface difference_surface(ExactSpace& space, const ConvexPolyhedron& outer,
                                const ConvexPolyhedron& original_inner) {
  if (original_inner.empty()) return surface(outer);
  std::vector<VertexId> outer_vertices = vertices_of(outer);
  sort_by_place(space, outer_vertices);
  const ConvexPolyhedron inner = with_shared_vertices(space, original_inner, outer_vertices);
  const Touching touch = touching(space, outer, inner);
  const EdgeVertices edge_vertices = inner_vertices_on_edges(space, touch, outer_vertices);
  const Neighbours next_to = neighbours(outer);

  ExactSurface result;
  for (std::size_t f = 0; f < outer.faces.size(); ++f) {
    const PlaneId plane = outer.faces[f].plane;
    const Loop loop = refined_loop(space, outer, f, next_to, edge_vertices);
    const auto hole = touch.on_face.find(f);
    Triangles triangles = hole == touch.on_face.end() ? convex_triangles(space, plane, loop)
                                                      : difference_triangles(space, plane, loop, hole->second);
    if (!triangles.empty()) result.facets.push_back({plane, std::move(triangles)});
  }
  const std::size_t first_inner = result.facets.size();
  for (std::size_t f = 0; f < inner.faces.size(); ++f) {
    if (touch.is_flush[f]) continue;
    const Face& face = inner.faces[f];
    result.facets.push_back({face.plane, turned(convex_triangles(space, face.plane, face.loop))});
  }
  split_fans(space, result, first_inner);
  return result;
}

}  // namespace gnomon
