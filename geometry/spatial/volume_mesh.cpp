#include "gnomon/shadow_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "geometry/bodies/boxes.h"
#include "geometry/numbers/rounding.h"
#include "geometry/spatial/clipping.h"
#include "geometry/spatial/difference_surface.h"
#include "geometry/spatial/pair_polyhedra.h"
#include "geometry/spatial/vertex_rounding.h"
#include "gnomon/errors.h"

namespace gnomon {
namespace {

/// Numbers the vertices that an output uses, in order of first use.
class OutputVertices {
 public:
  explicit OutputVertices(const ExactSpace& space) : indices_(space.vertex_count(), none) {
    used_.reserve(indices_.size());
  }

  std::uint32_t index(VertexId vertex) {
    if (indices_[vertex] == none) {
      indices_[vertex] = static_cast<std::uint32_t>(used_.size());
      used_.push_back(vertex);
    }
    return indices_[vertex];
  }
  std::vector<Point3> rounded(VertexRounding& rounding) const {
    std::vector<Point3> points;
    points.reserve(used_.size());
    for (const VertexId vertex : used_) points.push_back(rounding(vertex));
    return points;
  }

 private:
  static constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> indices_;
  std::vector<VertexId> used_;
};

std::size_t triangle_count(const ExactSurface& surface) {
  std::size_t count = 0;
  for (const ExactSurface::Facet& facet : surface.facets) count += facet.triangles.size();
  return count;
}

VolumeMesh volume_mesh(const ExactSpace& space, const ExactSurface& surface, VertexRounding& rounding) {
  VolumeMesh mesh;
  if (surface.facets.empty()) return mesh;
  OutputVertices vertices(space);
  mesh.facets.reserve(surface.facets.size());
  mesh.triangles.reserve(triangle_count(surface));
  for (const ExactSurface::Facet& facet : surface.facets) {
    const auto facet_index = static_cast<std::uint32_t>(mesh.facets.size());
    mesh.facets.push_back(space.name(facet.plane));
    mesh.truncated = mesh.truncated || mesh.facets.back().kind == FacetKind::clip_box;
    for (const auto& [a, b, c] : facet.triangles) {
      mesh.triangles.push_back({{vertices.index(a), vertices.index(b), vertices.index(c)}, facet_index});
    }
  }
  mesh.vertices = vertices.rounded(rounding);
  return mesh;
}

ExactNumber exact_volume(const ExactSpace& space, const ExactSurface& surface) {
  std::unordered_map<VertexId, ExactVector> points;
  const auto point = [&](VertexId v) -> const ExactVector& {
    const auto [entry, is_new] = points.try_emplace(v);
    if (is_new) entry->second = exact_coordinates(space, v);
    return entry->second;
  };
  Rational six_volumes = 0;
  for (const ExactSurface::Facet& facet : surface.facets) {
    for (const auto& [a, b, c] : facet.triangles) six_volumes += dot(point(a), cross(point(b), point(c)));
  }
  return exact_number(six_volumes / 6);
}

VolumeCells volume_cells(const ExactSpace& space, const std::vector<ConvexPolyhedron>& polyhedra,
                         VertexRounding& rounding) {
  VolumeCells result;
  if (polyhedra.empty()) return result;
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
  result.vertices = vertices.rounded(rounding);
  return result;
}

/// The face that lies in a plane, or the box's own face where the plane is a side of it.
Loop plane_in_box(ExactSpace& space, const ConvexPolyhedron& box, PlaneId plane) {
  for (const auto& face : clipped(space, box, plane).faces) {
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

/// A plane's polygon before rounding.
struct PlaneLoop {
  FacetName name;
  Loop loop;
};

/// What is made of a pair, before rounding.
struct ExactShapes {
  ExactSurface occlusion;
  ExactSurface umbra;
  ExactSurface penumbra;
  ExactSurface pockets;
  std::vector<ConvexPolyhedron> umbra_cells;
  std::vector<ConvexPolyhedron> penumbra_cells;
  std::vector<PlaneLoop> planes;
};

bool is_extremal(FacetKind kind) {
  return kind == FacetKind::separating_blocker_plane || kind == FacetKind::separating_light_plane ||
         kind == FacetKind::supporting_blocker_plane;
}

std::vector<PlaneLoop> plane_loops(ExactSpace& space, const PairHalfSpaces& half_spaces,
                                   const ConvexPolyhedron& whole_box) {
  std::vector<PlaneLoop> loops;
  for (const auto* list : {&half_spaces.occlusion, &half_spaces.umbra}) {
    for (const HalfSpace& half_space : *list) {
      if (!is_extremal(half_space.name.kind)) continue;
      loops.push_back({half_space.name, plane_in_box(space, whole_box, space.add_plane(half_space))});
    }
  }
  return loops;
}

ExactShapes exact_shapes(PairPolyhedra& polyhedra, const PreparedPair& pair, const ShadowParts& parts) {
  ExactSpace& space = polyhedra.planes.space;
  ExactShapes shapes;
  shapes.occlusion = surface(polyhedra.occlusion);
  shapes.umbra = surface(polyhedra.umbra);
  if (parts.penumbra && pair.has_penumbra()) {
    shapes.penumbra = difference_surface(space, polyhedra.occlusion, polyhedra.umbra);
  }
  if (parts.penumbra && pair.has_solid()) {
    shapes.pockets = difference_surface(space, polyhedra.umbra, solid_in_umbra(pair, polyhedra));
  }
  if (parts.cells && !polyhedra.umbra.empty()) shapes.umbra_cells = {polyhedra.umbra};
  if (parts.cells) shapes.penumbra_cells = penumbra_cells(pair, polyhedra);
  if (parts.planes) shapes.planes = plane_loops(space, pair.half_spaces, polyhedra.whole_box());
  return shapes;
}

}  // namespace

ShadowMeshes meshes_of(const PreparedPair& pair, const Box3& box, const ShadowParts& parts) {
  if (!has_interior(box)) throw PreconditionError("a clip box needs finite bounds with min < max");
  std::optional<PairPolyhedra> polyhedra;
  ExactShapes shapes;
  {
    const CGAL::Protect_FPU_rounding<true> protection;
    polyhedra.emplace(pair, box);
    shapes = exact_shapes(*polyhedra, pair, parts);
  }
  const ExactSpace& space = polyhedra->planes.space;
  VertexRounding rounding(space);
  ShadowMeshes meshes;
  meshes.occlusion = volume_mesh(space, shapes.occlusion, rounding);
  meshes.umbra = volume_mesh(space, shapes.umbra, rounding);
  meshes.penumbra = volume_mesh(space, shapes.penumbra, rounding);
  meshes.umbra_pockets = volume_mesh(space, shapes.pockets, rounding);
  meshes.umbra_cells = volume_cells(space, shapes.umbra_cells, rounding);
  meshes.penumbra_cells = volume_cells(space, shapes.penumbra_cells, rounding);
  for (const auto& [name, loop] : shapes.planes) {
    PlanePolygon& polygon = meshes.extremal_planes.emplace_back(PlanePolygon{name, {}});
    for (const VertexId v : loop) polygon.vertices.push_back(rounding(v));
  }
  if (parts.volumes) {
    meshes.occlusion.volume = exact_volume(space, shapes.occlusion);
    meshes.umbra.volume = exact_volume(space, shapes.umbra);
    meshes.penumbra.volume = exact_volume(space, shapes.penumbra);
    meshes.umbra_pockets.volume = exact_volume(space, shapes.pockets);
  }
  return meshes;
}

}  // namespace gnomon
