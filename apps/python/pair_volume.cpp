#include "apps/python/pair_volume.h"

namespace gnomon::python {
namespace {

/// The box as two rows, its least and its greatest corner.
Box3 box_of(const PairResult& pair, const py::object& box) {
  if (box.is_none()) {
    if (!pair.box) throw ArgumentError("box: found None, expected a box, as the scene has no usual one");
    return *pair.box;
  }
  const Rows corners(box, "box", 3);
  const bool is_box = corners.count() == 2 && corners.at(0, 0) < corners.at(1, 0) &&
                      corners.at(0, 1) < corners.at(1, 1) && corners.at(0, 2) < corners.at(1, 2);
  if (!is_box)
    throw ArgumentError("box: found no two corners, expected the least and the greatest, apart in x, y and z");
  return {corners.point(0), corners.point(1)};
}

const VolumeMesh& mesh_called(const ShadowMeshes& meshes, const std::string& name) {
  if (name == "occlusion") return meshes.occlusion;
  if (name == "umbra") return meshes.umbra;
  if (name == "penumbra") return meshes.penumbra;
  throw ArgumentError("volume: found '" + name + "', expected 'occlusion', 'umbra' or 'penumbra'");
}

}  // namespace

const char* kind_name(FacetKind kind) {
  constexpr const char* names[] = {
      "blocker_face", "separating_blocker_plane", "separating_light_plane", "supporting_blocker_plane", "clip_box",
      "light_plane"};
  return names[static_cast<int>(kind)];
}

py::object optional_index(const std::optional<std::uint32_t>& index) {
  return index ? py::object(py::int_(*index)) : py::object(py::none());
}

VolumeResult volume_of(const PairResult& pair, const std::string& name, const py::object& box) {
  mesh_called({}, name);
  const Box3 cut = box_of(pair, box);
  ShadowMeshes meshes;
  {
    const py::gil_scoped_release release;
    meshes = pair.shadow.meshes(cut, {.penumbra = name == "penumbra", .cells = false, .planes = false});
  }
  const VolumeMesh& mesh = mesh_called(meshes, name);
  std::vector<std::array<std::uint32_t, 3>> corners;
  py::array_t<std::uint32_t> of_facets(static_cast<py::ssize_t>(mesh.triangles.size()));
  std::uint32_t* next = of_facets.mutable_data();
  for (const MeshTriangle& triangle : mesh.triangles) {
    corners.push_back(triangle.vertices);
    *next++ = triangle.facet;
  }
  py::list facets;
  for (const FacetName& facet : mesh.facets) {
    facets.append(
        py::make_tuple(kind_name(facet.kind), optional_index(facet.edge_index), optional_index(facet.vertex_index)));
  }
  return {name,   points_array(mesh.vertices), index_array<3>(corners),     of_facets,
          facets, mesh.volume.nearest,         fraction(mesh.volume.exact), mesh.truncated};
}

void bind_volume(py::module_& module) {
  py::class_<VolumeResult> volume_class(module, "Volume", "A volume as a closed triangle surface, cut by a box.");
  bind_to_vtk(volume_class);
  volume_class.def_readonly("name", &VolumeResult::name, "\"occlusion\", \"umbra\" or \"penumbra\".")
      .def_readonly("vertices", &VolumeResult::vertices, "(v, 3): constructed exactly, each coordinate rounded once.")
      .def_readonly("triangles", &VolumeResult::triangles,
                    "(t, 3): indices of vertices, counterclockwise from outside.")
      .def_readonly("triangle_facets", &VolumeResult::triangle_facets, "(t,): the facet of each triangle.")
      .def_readonly(
          "facets", &VolumeResult::facets,
          "Of each facet its kind and the edge and the vertex of its plane, as of a Plane; None where it has none.")
      .def_readonly("volume", &VolumeResult::volume, "That of the exact mesh, correctly rounded.")
      .def_readonly("exact_volume", &VolumeResult::exact_volume, "The same as a fractions.Fraction.")
      .def_readonly("truncated", &VolumeResult::truncated, "True if a side of the box bounds it.");
}

}  // namespace gnomon::python
