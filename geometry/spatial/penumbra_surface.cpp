#include "geometry/spatial/penumbra_surface.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "geometry/spatial/difference_triangulation.h"
#include "geometry/spatial/split_fans.h"

namespace gnomon {
namespace {

using Face = ConvexPolyhedron::Face;

/// Names the plane of a face so that faces of occlusion and umbra in one plane get one name: the side of the box it
/// lies in, or the supporting plane for a separating plane that holds the whole light, or its own plane.
class CommonPlanes {
 public:
  CommonPlanes(const ExactSpace& space, const ShadowPolyhedra& polyhedra, const PairHalfSpaces& half_spaces,
               const std::array<PlaneId, 6>& box)
      : space_(space), box_(box) {
    for (std::size_t k = 0; k < half_spaces.supporting.size(); ++k) {
      if (half_spaces.supporting[k].holds_light) {
        same_plane_[polyhedra.separating_blocker[k]] = polyhedra.supporting_blocker[k];
      }
    }
  }

  PlaneId of(const Face& face) const {
    for (const PlaneId side : box_) {
      const auto on_side = [&](VertexId v) { return space_.side(side, v) == 0; };
      if (face.plane == side || std::all_of(face.loop.begin(), face.loop.begin() + 3, on_side)) return side;
    }
    const auto entry = same_plane_.find(face.plane);
    return entry == same_plane_.end() ? face.plane : entry->second;
  }

  /// The sides of the box on which a vertex lies.
  std::vector<PlaneId> box_sides(VertexId vertex) const {
    std::vector<PlaneId> sides;
    std::copy_if(box_.begin(), box_.end(), std::back_inserter(sides),
                 [&](PlaneId side) { return space_.side(side, vertex) == 0; });
    return sides;
  }

 private:
  const ExactSpace& space_;
  const std::array<PlaneId, 6>& box_;
  std::unordered_map<PlaneId, PlaneId> same_plane_;
};

std::vector<VertexId> sorted_vertices(const ExactSpace& space, const ConvexPolyhedron& polyhedron) {
  std::set<VertexId> ids;
  for (const Face& face : polyhedron.faces) ids.insert(face.loop.begin(), face.loop.end());
  std::vector<VertexId> vertices(ids.begin(), ids.end());
  std::sort(vertices.begin(), vertices.end(), [&](VertexId a, VertexId b) { return space.compare(a, b) < 0; });
  return vertices;
}

/// The umbra with every vertex that is also one of the occlusion replaced by that one.
ConvexPolyhedron with_shared_vertices(const ExactSpace& space, ConvexPolyhedron umbra,
                                      const std::vector<VertexId>& occlusion_vertices) {
  std::unordered_map<VertexId, VertexId> known;
  const auto shared = [&](VertexId v) {
    const auto [entry, is_new] = known.try_emplace(v, v);
    if (!is_new) return entry->second;
    const auto at = std::lower_bound(occlusion_vertices.begin(), occlusion_vertices.end(), v,
                                     [&](VertexId a, VertexId b) { return space.compare(a, b) < 0; });
    if (at != occlusion_vertices.end() && space.compare(*at, v) == 0) entry->second = *at;
    return entry->second;
  };
  for (Face& face : umbra.faces) std::transform(face.loop.begin(), face.loop.end(), face.loop.begin(), shared);
  return umbra;
}

/// An edge of the occlusion by the two planes (as CommonPlanes names them) that meet in it.
using EdgeName = std::array<PlaneId, 2>;

EdgeName edge_name(PlaneId a, PlaneId b) {
  return {std::min(a, b), std::max(a, b)};
}

/// For each edge of the occlusion the umbra's vertices strictly inside it, in lexicographic order.
using EdgeVertices = std::map<EdgeName, std::vector<VertexId>>;

EdgeVertices umbra_vertices_on_edges(const ExactSpace& space, const CommonPlanes& planes,
                                     const std::vector<VertexId>& occlusion_vertices,
                                     const std::set<PlaneId>& occlusion, const ConvexPolyhedron& umbra) {
  std::map<VertexId, std::set<PlaneId>> planes_of_vertex;
  for (const Face& face : umbra.faces) {
    const PlaneId plane = planes.of(face);
    for (const VertexId v : face.loop) planes_of_vertex[v].insert(plane);
  }
  const std::set<VertexId> corners(occlusion_vertices.begin(), occlusion_vertices.end());
  EdgeVertices result;
  for (auto& [vertex, on] : planes_of_vertex) {
    if (corners.count(vertex)) continue;
    for (const PlaneId side : planes.box_sides(vertex)) on.insert(side);
    std::vector<PlaneId> common;
    std::set_intersection(on.begin(), on.end(), occlusion.begin(), occlusion.end(), std::back_inserter(common));
    if (common.size() == 2) result[edge_name(common[0], common[1])].push_back(vertex);
  }
  for (auto& [edge, vertices] : result) {
    std::sort(vertices.begin(), vertices.end(), [&](VertexId a, VertexId b) { return space.compare(a, b) < 0; });
  }
  return result;
}

using Neighbours = std::map<std::array<VertexId, 2>, PlaneId>;

/// A face's loop with the umbra's vertices put into its edges.
Loop refined_loop(const ExactSpace& space, const Face& face, PlaneId plane, const Neighbours& neighbours,
                  const EdgeVertices& edge_vertices) {
  Loop loop;
  VertexId u = face.loop.back();
  for (const VertexId v : face.loop) {
    const auto entry = edge_vertices.find(edge_name(plane, neighbours.at({v, u})));
    if (entry != edge_vertices.end()) {
      Loop inside = entry->second;
      if (space.compare(u, v) > 0) std::reverse(inside.begin(), inside.end());
      loop.insert(loop.end(), inside.begin(), inside.end());
    }
    loop.push_back(v);
    u = v;
  }
  return loop;
}

/// The vertices in which the umbra touches the sides of the box that hold no facet of it: one, or the ends of an edge.
std::map<PlaneId, Loop> touching_vertices(const CommonPlanes& planes, const ConvexPolyhedron& umbra,
                                          const std::map<PlaneId, const Face*>& umbra_faces) {
  std::set<VertexId> vertices;
  for (const Face& face : umbra.faces) vertices.insert(face.loop.begin(), face.loop.end());
  std::map<PlaneId, Loop> touching;
  for (const VertexId vertex : vertices) {
    for (const PlaneId side : planes.box_sides(vertex)) {
      if (!umbra_faces.count(side)) touching[side].push_back(vertex);
    }
  }
  return touching;
}

Triangles turned(Triangles triangles) {
  for (auto& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

}  // namespace

ExactSurface surface(const ConvexPolyhedron& polyhedron) {
  ExactSurface result;
  for (const Face& face : polyhedron.faces) {
    ExactSurface::Facet facet{face.plane, {}};
    for (std::size_t i = 1; i + 1 < face.loop.size(); ++i) {
      facet.triangles.push_back({face.loop[0], face.loop[i], face.loop[i + 1]});
    }
    result.facets.push_back(std::move(facet));
  }
  return result;
}

ExactSurface penumbra_surface(ExactSpace& space, const ConvexPolyhedron& occlusion, const ConvexPolyhedron& umbra,
                              const ShadowPolyhedra& polyhedra, const PairHalfSpaces& half_spaces,
                              const std::array<PlaneId, 6>& box) {
  if (umbra.empty()) return surface(occlusion);
  const CommonPlanes planes(space, polyhedra, half_spaces, box);
  const std::vector<VertexId> corners = sorted_vertices(space, occlusion);
  const ConvexPolyhedron inner = with_shared_vertices(space, umbra, corners);
  Neighbours neighbours;
  std::set<PlaneId> occlusion_planes;
  for (const Face& face : occlusion.faces) {
    const PlaneId plane = planes.of(face);
    occlusion_planes.insert(plane);
    for (std::size_t i = 0; i < face.loop.size(); ++i) {
      neighbours[{face.loop[i], face.loop[(i + 1) % face.loop.size()]}] = plane;
    }
  }
  const EdgeVertices edge_vertices = umbra_vertices_on_edges(space, planes, corners, occlusion_planes, inner);
  std::map<PlaneId, const Face*> inner_faces;
  for (const Face& face : inner.faces) inner_faces[planes.of(face)] = &face;

  std::map<PlaneId, Loop> holes = touching_vertices(planes, inner, inner_faces);
  for (const auto& [plane, face] : inner_faces) holes[plane] = face->loop;

  ExactSurface result;
  for (const Face& face : occlusion.faces) {
    const PlaneId plane = planes.of(face);
    const Loop loop = refined_loop(space, face, plane, neighbours, edge_vertices);
    const auto hole = holes.find(plane);
    Triangles triangles = hole == holes.end() ? convex_triangles(space, face.plane, loop)
                                              : difference_triangles(space, face.plane, loop, hole->second);
    if (!triangles.empty()) result.facets.push_back({face.plane, std::move(triangles)});
  }
  const std::size_t first_inner = result.facets.size();
  for (const auto& [plane, face] : inner_faces) {
    if (occlusion_planes.count(plane)) continue;
    result.facets.push_back({face->plane, turned(convex_triangles(space, face->plane, face->loop))});
  }
  split_fans(space, result, first_inner);
  return result;
}

}  // namespace gnomon
