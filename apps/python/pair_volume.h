#pragma once

/// A pair, and its volumes as arrays.

#include <optional>
#include <string>

#include "apps/python/arrays.h"
#include "gnomon/shadow_mesh.h"

namespace gnomon::python {

/// One light and one convex blocker, and their volumes.
struct PairResult {
  std::string light, blocker;
  ShadowPair shadow;
  ShadowVolumes volumes;
  std::optional<Box3> box;  ///< by which volumes are cut unless one is given
};

/// A volume as a closed triangle surface.
struct VolumeResult {
  std::string name;
  py::array_t<double> vertices;
  py::array_t<std::uint32_t> triangles, triangle_facets;
  py::list facets;  ///< (kind, edge, vertex)
  double volume = 0;
  py::object exact_volume;
  bool truncated = false;
};

/// The name of a kind of facets, as scripts read it.
const char* kind_name(FacetKind kind);

/// An index, or None.
py::object optional_index(const std::optional<std::uint32_t>& index);

/// "occlusion", "umbra" or "penumbra", cut by a box: two rows, or None for the usual one.
///
/// Throws: ArgumentError.
VolumeResult volume_of(const PairResult& pair, const std::string& name, const py::object& box);

/// The class gnomon.Volume.
void bind_volume(py::module_& module);

}  // namespace gnomon::python
