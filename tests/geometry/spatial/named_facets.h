#pragma once

/// The facets of a pair's meshes told by the points their planes go through and by their vertices, not by indices.

#include <vector>

#include "gnomon/shadow_mesh.h"
#include "tests/geometry/spatial/named_planes.h"

namespace gnomon {

/// A facet: all that it may be named after (several half-spaces of a pair may lie in one plane; a side of the box has
/// none), and its vertices, each once. Left out are vertices that are none of occlusion, umbra or blocker: where sheets
/// of a penumbra touch along an edge, it depends on the numbering which of them is divided at its middle.
struct NamedFacet {
  std::vector<NamedPlane> planes;
  std::vector<Point3> vertices;

  friend bool operator==(const NamedFacet&, const NamedFacet&) = default;
};

/// The four meshes of a pair in the order occlusion, umbra, penumbra, pockets.
std::vector<const VolumeMesh*> all_meshes(const ShadowMeshes& meshes);

/// The facets of one of them, in no order.
std::vector<NamedFacet> named_facets(const Light& light, const ConvexBlocker& blocker, const ShadowMeshes& meshes,
                                     std::size_t which);

void sort(std::vector<NamedPlane>& planes);
void sort(std::vector<NamedFacet>& facets);

}  // namespace gnomon
