#include "geometry/spatial/volume_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "geometry/errors.h"
#include "geometry/rounding.h"
#include "geometry/spatial/difference_triangulation.h"
#include "geometry/spatial/penumbra_surface.h"

namespace gnomon {
namespace {

std::array<Rational, 3> cartesian(const ExactSpace& space, VertexId vertex) {
  const Quadruple<Rational>& v = space.exact_vertex(vertex);
  return {Rational(v[0] / v[3]), Rational(v[1] / v[3]), Rational(v[2] / v[3])};
}

/// Numbers the vertices that an output uses, in order of first use, and rounds each once.
class OutputVertices {
 public:
  explicit OutputVertices(const ExactSpace& space) : space_(space) {}

  std::uint32_t index(VertexId vertex) {
    const auto [entry, is_new] = indices_.try_emplace(vertex, static_cast<std::uint32_t>(exact_.size()));
    if (is_new) exact_.push_back(cartesian(space_, vertex));
    return entry->second;
  }
  const std::array<Rational, 3>& exact(std::uint32_t index) const { return exact_[index]; }
  std::vector<Point3> rounded() const {
    std::vector<Point3> points;
    for (const auto& p : exact_) points.push_back({nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])});
    return points;
  }

 private:
  const ExactSpace& space_;
  std::unordered_map<VertexId, std::uint32_t> indices_;
  std::vector<std::array<Rational, 3>> exact_;
};

Rational determinant(const std::array<Rational, 3>& a, const std::array<Rational, 3>& b,
                     const std::array<Rational, 3>& c) {
  return CGAL::determinant<Rational>(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]);
}

VolumeMesh volume_mesh(const ExactSpace& space, const ExactSurface& surface) {
  VolumeMesh mesh;
  OutputVertices vertices(space);
  Rational six_volumes = 0;
  for (const ExactSurface::Facet& facet : surface.facets) {
    const auto facet_index = static_cast<std::uint32_t>(mesh.facets.size());
    mesh.facets.push_back(space.name(facet.plane));
    mesh.truncated = mesh.truncated || mesh.facets.back().kind == FacetKind::clip_box;
    for (const auto& [a, b, c] : facet.triangles) {
      const MeshTriangle triangle{{vertices.index(a), vertices.index(b), vertices.index(c)}, facet_index};
      mesh.triangles.push_back(triangle);
      const auto& [i, j, k] = triangle.vertices;
      six_volumes += determinant(vertices.exact(i), vertices.exact(j), vertices.exact(k));
    }
  }
  mesh.vertices = vertices.rounded();
  mesh.volume = exact_number(six_volumes / 6);
  return mesh;
}

VolumeCells volume_cells(const ExactSpace& space, const std::vector<ConvexPolyhedron>& polyhedra) {
  VolumeCells result;
  OutputVertices vertices(space);
  for (const ConvexPolyhedron& polyhedron : polyhedra) {
    VolumeCells::Cell cell;
    for (const auto& face : polyhedron.faces) {
      VolumeCells::Face loop;
      for (const VertexId v : face.loop) loop.push_back(vertices.index(v));
      cell.faces.push_back(std::move(loop));
    }
    result.cells.push_back(std::move(cell));
  }
  result.vertices = vertices.rounded();
  return result;
}

/// The face that lies in a plane, or the box's own face where the plane is a side of it.
Loop plane_in_box(ExactSpace& space, const ConvexPolyhedron& box, PlaneId plane) {
  for (const auto& face : space.clipped(box, plane).faces) {
    if (face.plane == plane) return face.loop;
  }
  for (const auto& face : box.faces) {
    const auto on_plane = [&](VertexId v) { return space.side(plane, v) == 0; };
    if (!std::all_of(face.loop.begin(), face.loop.end(), on_plane)) continue;
    Loop loop = face.loop;
    if (space.turn(plane, loop[0], loop[1], loop[2]) < 0) std::reverse(loop.begin(), loop.end());
    return loop;
  }
  return {};
}

void append_planes(std::vector<PlanePolygon>& polygons, ExactSpace& space, const ConvexPolyhedron& box,
                   const std::vector<HalfSpace>& half_spaces) {
  for (const HalfSpace& half_space : half_spaces) {
    const PlaneId plane = space.add_plane(half_space);
    OutputVertices vertices(space);
    for (const VertexId v : plane_in_box(space, box, plane)) vertices.index(v);
    polygons.push_back({half_space.name, vertices.rounded()});
  }
}

void require_proper(const Box3& box) {
  const bool ordered = box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z;
  const Point3& a = box.min;
  const Point3& b = box.max;
  const bool finite = std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z) && std::isfinite(b.x) &&
                      std::isfinite(b.y) && std::isfinite(b.z);
  if (!ordered || !finite) throw PreconditionError("a clip box needs finite bounds with min < max");
}

}  // namespace

ShadowMeshes shadow_meshes(const Light& light, const ConvexPolygon& blocker, const Box3& box) {
  require_proper(box);
  const StandardPair pair = standard_pair(light, blocker);
  const PairHalfSpaces half_spaces(pair);
  const CGAL::Protect_FPU_rounding<true> protection;
  ShadowPolyhedra polyhedra(pair, half_spaces);
  ExactSpace& space = polyhedra.space;
  const std::array<PlaneId, 6> sides = add_box(space, box);
  const ConvexPolyhedron occlusion = clipped_by_box(space, polyhedra.occlusion, sides);
  const ConvexPolyhedron umbra = clipped_by_box(space, polyhedra.umbra, sides);

  ShadowMeshes meshes;
  meshes.occlusion = volume_mesh(space, surface(occlusion));
  meshes.umbra = volume_mesh(space, surface(umbra));
  if (!umbra.empty()) meshes.umbra_cells = volume_cells(space, {umbra});
  if (pair.light.size() > 1) {  // a point light has no penumbra
    meshes.penumbra = volume_mesh(space, penumbra_surface(space, occlusion, umbra, polyhedra, half_spaces, sides));
    meshes.penumbra_cells = volume_cells(space, penumbra_cells(space, occlusion, polyhedra.supporting_blocker));
  }
  const ConvexPolyhedron whole_box = space.box(box, sides);
  append_planes(meshes.extremal_planes, space, whole_box, half_spaces.separating_blocker);
  append_planes(meshes.extremal_planes, space, whole_box, half_spaces.separating_light);
  append_planes(meshes.extremal_planes, space, whole_box, half_spaces.supporting_blocker);
  return meshes;
}

}  // namespace gnomon
