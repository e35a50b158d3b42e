#include "tests/geometry/spatial/named_facets.h"

#include <algorithm>

#include "gnomon/errors.h"

namespace gnomon {
namespace {

/// The half-spaces of the volumes and of the blocker's own facets: whatever a facet may be named after.
std::vector<HalfSpace> all_half_spaces(const Light& light, const ConvexBlocker& blocker) {
  const ShadowVolumes volumes = shadow_volumes(light, blocker);
  std::vector<HalfSpace> all = volumes.occlusion.half_spaces;
  all.insert(all.end(), volumes.umbra.half_spaces.begin(), volumes.umbra.half_spaces.end());
  const auto* solid = std::get_if<ConvexSolid>(&blocker);
  if (!solid) return all;
  for (std::size_t f = 0; f < solid->facets().size(); ++f) {
    const auto at = [&](std::size_t k) { return solid->points()[solid->facets()[f].loop[k]]; };
    all.push_back({{FacetKind::blocker_face, {}, static_cast<std::uint32_t>(f)}, {at(0), at(1), at(2)}});
  }
  return all;
}

/// All that a facet of this name may be. Diagonals of a rounded light bear no number, so several half-spaces may have
/// one name.
std::vector<NamedPlane> planes_of(const Light& light, const ConvexBlocker& blocker, const std::vector<HalfSpace>& all,
                                  const FacetName& name) {
  if (name.kind == FacetKind::clip_box) return {};
  std::vector<NamedPlane> result;
  for (const HalfSpace& half_space : all) {
    const auto is_one = [&](const HalfSpace& own) { return own.name == name && is_same_plane(own, half_space); };
    if (std::any_of(all.begin(), all.end(), is_one)) result.push_back(named_plane(light, blocker, half_space));
  }
  if (result.empty()) throw PreconditionError("a facet without a half-space");
  sort(result);
  return result;
}

template <class Element>
bool is_less(const std::vector<Element>& a, const std::vector<Element>& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](const Element& x, const Element& y) { return is_before(x, y); });
}

}  // namespace

std::vector<const VolumeMesh*> all_meshes(const ShadowMeshes& meshes) {
  return {&meshes.occlusion, &meshes.umbra, &meshes.penumbra, &meshes.umbra_pockets};
}

std::vector<NamedFacet> named_facets(const Light& light, const ConvexBlocker& blocker, const ShadowMeshes& meshes,
                                     std::size_t which) {
  std::vector<Point3> proper = points_of(blocker);
  for (const VolumeMesh* mesh : {&meshes.occlusion, &meshes.umbra}) {
    proper.insert(proper.end(), mesh->vertices.begin(), mesh->vertices.end());
  }
  sort_distinct(proper);
  const auto is_proper = [&](const Point3& p) {
    return std::binary_search(proper.begin(), proper.end(), p,
                              [](const Point3& a, const Point3& b) { return is_before(a, b); });
  };
  const VolumeMesh& mesh = *all_meshes(meshes)[which];
  const std::vector<HalfSpace> all = all_half_spaces(light, blocker);
  std::vector<NamedFacet> result;
  for (const FacetName& name : mesh.facets) result.push_back({planes_of(light, blocker, all, name), {}});
  for (const MeshTriangle& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle.vertices) {
      if (is_proper(mesh.vertices[v])) result[triangle.facet].vertices.push_back(mesh.vertices[v]);
    }
  }
  for (NamedFacet& facet : result) sort_distinct(facet.vertices);
  return result;
}

void sort(std::vector<NamedPlane>& planes) {
  std::sort(planes.begin(), planes.end(), [](const NamedPlane& a, const NamedPlane& b) { return is_before(a, b); });
}

void sort(std::vector<NamedFacet>& facets) {
  std::sort(facets.begin(), facets.end(), [](const NamedFacet& a, const NamedFacet& b) {
    return a.vertices == b.vertices ? is_less(a.planes, b.planes) : is_less(a.vertices, b.vertices);
  });
}

}  // namespace gnomon
