#include <pybind11/stl.h>

#include <algorithm>
#include <optional>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/scene_pairs.h"
#include "apps/python/arrays.h"
#include "apps/python/bindings.h"
#include "apps/python/long_work.h"
#include "apps/python/pair_volume.h"

namespace gnomon::python {
namespace {

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
      .def("volume", &volume_of, py::arg("volume"), py::arg("box") = py::none(),
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
