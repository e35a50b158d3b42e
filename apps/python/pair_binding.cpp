#include <pybind11/stl.h>

#include <algorithm>
#include <optional>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/scene_pairs.h"
#include "apps/python/arrays.h"
#include "apps/python/bindings.h"
#include "apps/python/long_work.h"
#include "gnomon/shadow_mesh.h"

namespace gnomon::python {
namespace {

/// One light and one convex blocker, and their volumes.
struct PairResult {
  std::string light, blocker;
  ShadowPair shadow;
  ShadowVolumes volumes;
  std::optional<Box3> box;  ///< by which volumes are cut unless one is given
};

/// The name of the element that has the part: `vase` of `vase#12`.
std::string element_of(const std::string& name) {
  return name.substr(0, name.find('#'));
}

/// The one pair that is meant; names of parts are told where several are.
const ScenePair& meant(const std::vector<ScenePair>& pairs, const std::string& light, const std::string& blocker) {
  std::vector<const ScenePair*> found;
  for (const ScenePair& pair : pairs) {
    const bool is_light = pair.light == light || element_of(pair.light) == light;
    const bool is_blocker = pair.blocker == blocker || element_of(pair.blocker) == blocker;
    if (is_light && is_blocker) found.push_back(&pair);
  }
  if (found.size() == 1) return *found.front();
  if (found.empty()) throw ArgumentError("blocker: found '" + blocker + "', which has no such part");
  const ScenePair& last = *found.back();
  throw ArgumentError("found " + std::to_string(found.size()) + " pairs of convex parts, expected one, as of '" +
                      last.light + "' and '" + last.blocker + "'");
}

PairResult pair_of(const SceneValue& value, const std::string& light, const std::string& blocker) {
  const std::shared_ptr<PreparedScene> scene = value.prepared();
  scene->space("a pair");
  const std::vector<ScenePair> pairs = scene_pairs(scene->scene(), {light, element_of(blocker)});
  const ScenePair& pair = meant(pairs, light, blocker);
  if (!pair.supported()) {
    throw UnsupportedError("light '" + pair.light + "', blocker '" + pair.blocker + "': " + pair.reason);
  }
  return {pair.light, pair.blocker, *pair.shadow, pair.shadow->volumes(), default_clip_box(scene->scene())};
}

const char* kind_name(FacetKind kind) {
  constexpr const char* names[] = {
      "blocker_face", "separating_blocker_plane", "separating_light_plane", "supporting_blocker_plane", "clip_box",
      "light_plane"};
  return names[static_cast<int>(kind)];
}

py::object optional_index(const std::optional<std::uint32_t>& index) {
  return index ? py::object(py::int_(*index)) : py::object(py::none());
}

/// A plane with the numbers of the half-space of its name, where the volume has one.
py::object plane(const FacetName& facet, const ConvexVolume& volume) {
  py::object coefficients = py::none(), exact = py::none();
  const auto found = std::ranges::find(volume.half_spaces, facet, &HalfSpace::name);
  if (found != volume.half_spaces.end()) {
    py::list nearest, fractions;
    for (const ExactNumber& number : plane_coefficients(*found)) {
      nearest.append(number.nearest);
      fractions.append(fraction(number.exact));
    }
    coefficients = py::tuple(nearest);
    exact = py::tuple(fractions);
  }
  const py::object type = py::module_::import("gnomon.results").attr("Plane");
  return type(kind_name(facet.kind), optional_index(facet.edge_index), optional_index(facet.vertex_index), coefficients,
              exact);
}

template <class Named>
FacetName facet_of(FacetKind kind, const Named& plane) {
  return {kind, plane.edge ? std::optional(number(*plane.edge)) : std::nullopt, number(plane.vertex)};
}

py::list planes(const PairResult& pair) {
  using enum FacetKind;
  const ShadowVolumes& volumes = pair.volumes;
  py::list list;
  for (const auto& p : volumes.planes.separating_blocker) {
    list.append(plane(facet_of(separating_blocker_plane, p), volumes.occlusion));
  }
  for (const auto& p : volumes.planes.separating_light) {
    list.append(plane(facet_of(separating_light_plane, p), volumes.occlusion));
  }
  for (const auto& p : volumes.planes.supporting_blocker) {
    list.append(plane(facet_of(supporting_blocker_plane, p), volumes.umbra));
  }
  return list;
}

const ConvexVolume& convex_volume(const PairResult& pair, const std::string& name) {
  if (name == "umbra") return pair.volumes.umbra;
  if (name == "occlusion") return pair.volumes.occlusion;
  throw ArgumentError("volume: found '" + name + "', expected 'occlusion' or 'umbra'");
}

/// -1 inside, 0 on the boundary, 1 outside.
py::array_t<std::int8_t> sides(const PairResult& pair, const py::object& points, const std::string& name,
                               unsigned threads) {
  const ConvexVolume& volume = convex_volume(pair, name);
  const Rows at(points, "points", 3);
  py::array_t<std::int8_t> result(static_cast<py::ssize_t>(at.count()));
  std::int8_t* side = result.mutable_data();
  without_lock(at.count(), threads_for(at.count(), threads), [&](std::size_t i, std::size_t) {
    side[i] = volume.empty ? std::int8_t{1}
                           : static_cast<std::int8_t>(static_cast<int>(volume.oriented_side(at.point(i))) - 1);
  });
  return result;
}

py::dict facts_of(const PairResult& pair, const std::string& name) {
  const ShadowVolumes& v = pair.volumes;
  const VolumeFacts* facts = name == "occlusion"  ? &v.occlusion_facts
                             : name == "umbra"    ? &v.umbra_facts
                             : name == "penumbra" ? &v.penumbra_facts
                                                  : nullptr;
  if (!facts) throw ArgumentError("volume: found '" + name + "', expected 'occlusion', 'umbra' or 'penumbra'");
  py::dict result;
  result["empty"] = facts->empty;
  result["bounded"] = facts->bounded;
  result["components"] = facts->components;
  return result;
}

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

struct VolumeResult {
  std::string name;
  py::array_t<double> vertices;
  py::array_t<std::uint32_t> triangles, triangle_facets;
  py::list facets;  ///< (kind, edge, vertex)
  double volume = 0;
  py::object exact_volume;
  bool truncated = false;
};

VolumeResult volume(const PairResult& pair, const std::string& name, const py::object& box) {
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

}  // namespace

void bind_pair(py::module_& module, SceneClass& scene) {
  bind_volume(module);
  py::class_<PairResult>(module, "Pair", R"(One light and one convex blocker: occlusion, umbra and penumbra.

occlusion: the points that lose some of the light; umbra: those that lose all of it;
penumbra: the rest of the occlusion. Everything is decided exactly.)")
      .def_readonly("light", &PairResult::light, "The name of the light, or of its part.")
      .def_readonly("blocker", &PairResult::blocker, "The name of the blocker, or of its convex part.")
      .def_property_readonly(
          "position", [](const PairResult& pair) { return std::string(name(pair.shadow.position())); },
          "How the two stand to each other, by the name of the case: \"standard\", \"touching\", ...")
      .def("planes", &planes,
           "The extremal planes, each a Plane: separating ones bound the occlusion, supporting ones the umbra.")
      .def("facts", &facts_of, py::arg("volume"),
           "Whether \"occlusion\", \"umbra\" or \"penumbra\" is empty, bounded, and in how many components: a "
           "dictionary.")
      .def("volume", &volume, py::arg("volume"), py::arg("box") = py::none(),
           R"("occlusion", "umbra" or "penumbra" as a Volume, cut exactly by a box.

box: its least and greatest corner, (2, 3); without it the bounding box of the scene,
grown on every side by half its diagonal. Raises ArgumentError.)")
      .def("sides", &sides, py::arg("points"), py::arg("volume") = "umbra", py::kw_only(), py::arg("threads") = 0,
           R"(On which side of the "umbra" or the "occlusion" points lie, decided exactly.

points: (n, 3). Returns (n,) of int8: -1 inside, 0 on the boundary, 1 outside.
Raises ArgumentError.)")
      .def("__repr__",
           [](const PairResult& pair) { return "<gnomon.Pair '" + pair.light + "', '" + pair.blocker + "'>"; });
  scene.def("pair", &pair_of, py::arg("light"), py::arg("blocker"),
            R"(A light and a blocker of the scene as a Pair.

Concave polygons and meshes count as their convex parts, each a pair of its own:
"vase#12". Raises ArgumentError for names that the scene does not have and where several
parts could be meant; UnsupportedError, with the program's sentence, for the one kind of
pair that has no volumes, and in scenes of dimension 2.)");
}

}  // namespace gnomon::python
