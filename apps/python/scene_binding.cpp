#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

#include "apps/python/arrays.h"
#include "apps/python/bindings.h"
#include "apps/python/document.h"

namespace gnomon::python {
namespace {

using Json = nlohmann::ordered_json;

bool is_space(const SceneValue& scene) {
  return scene.document().at("dimension") == 3;
}

/// The shape that so many vertices have, unless one is named.
const char* usual_shape(const SceneValue& scene, const char* list, const Json& element) {
  if (element.contains("position")) return "point";
  if (element.contains("direction")) return "direction";
  if (element.contains("facets") || element.contains("file")) return "mesh";
  const std::size_t count = element.contains("vertices") ? element["vertices"].size() : 0;
  if (is_space(scene)) return count == 2 && std::string_view(list) == "lights" ? "segment" : "polygon";
  return count > 2 ? "polyline" : "segment";
}

void add(SceneValue& scene, const char* list, const py::str& name, py::handle vertices, py::handle facets,
         py::handle shape, const py::kwargs& keys) {
  Json element = Json::object();
  element["name"] = json_of(name, "name");
  if (!shape.is_none()) element["shape"] = json_of(shape, "shape");
  if (!vertices.is_none()) element["vertices"] = json_of(vertices, "vertices");
  if (!facets.is_none()) element["facets"] = json_of(facets, "facets");
  const Json others = json_of(keys, "");
  for (const auto& [key, value] : others.items()) {
    if (!value.is_null()) element[key] = value;
  }
  if (!element.contains("shape")) element["shape"] = usual_shape(scene, list, element);
  scene.add(list, std::move(element));
}

template <const char* const& List>
void add_to(SceneValue& scene, const py::str& name, const py::object& vertices, const py::object& facets,
            const py::object& shape, const py::kwargs& keys) {
  add(scene, List, name, vertices, facets, shape, keys);
}

constexpr const char* lights_key = "lights";
constexpr const char* blockers_key = "blockers";
constexpr const char* receivers_key = "receivers";

template <const char* const& List>
py::tuple names_in(const SceneValue& scene) {
  py::list names;
  if (!scene.document().contains(List)) return names;
  for (const Json& element : scene.document()[List]) names.append(element["name"].get<std::string>());
  return names;
}

py::tuple doubts(const SceneValue& scene) {
  return py::tuple(py::cast(facts(scene.prepared()->scene()).doubts));
}

std::string text_of(const SceneValue& scene) {
  const auto count = [&](const char* list) {
    const Json& document = scene.document();
    return std::to_string(document.contains(list) ? document[list].size() : 0) + ' ' + list;
  };
  return "<gnomon.Scene of dimension " + scene.document().at("dimension").dump() + ": " + count("lights") + ", " +
         count("blockers") + ", " + count("receivers") + ">";
}

/// As the program prints them.
SceneValue with_warnings(SceneValue scene) {
  constexpr std::size_t most = 10;
  const std::shared_ptr<PreparedScene> prepared = scene.prepared();
  const auto& [source, unit, found, of_lighting] = facts(prepared->scene());
  for (std::size_t i = 0; i < std::min(most, found.size()); ++i) warn(source + ": " + found[i]);
  if (found.size() > most) warn(std::to_string(found.size() - most) + " further doubts, which Scene.doubts tells");
  return scene;
}

void bind_ways_in(SceneClass& scene) {
  scene.def(py::init([](int of, const py::str& unit) {
              return SceneValue(of, json_of(unit, "length_unit").get<std::string>());
            }),
            py::arg("dimension") = 3, py::arg("length_unit") = "m",
            R"(A scene without elements, of space (dimension 3) or of the plane (2).

length_unit is that of all coordinates: "mm", "cm", "m", "km", "in" or "ft".)");
  scene.def_static(
      "read", [](const std::filesystem::path& file) { return with_warnings(SceneValue::read(file)); }, py::arg("file"),
      R"(Reads and checks a scene file.

Raises SceneError with file, place, element, what was found and what was expected;
UnsupportedError for what makes sense but is not available. Doubts are told as
SceneWarning, as the program prints them.)");
  scene.def_static(
      "from_dict",
      [](const py::dict& document, const std::filesystem::path& folder) {
        return with_warnings(SceneValue::from_dict(document, folder));
      },
      py::arg("document"), py::arg("folder") = ".",
      R"(A scene from a dictionary with the keys of a scene file.

Lists may be arrays; numbers are taken as doubles. Mesh files are looked up in
folder. Raises SceneError, UnsupportedError; ArgumentError for what no scene file
can hold. Doubts are told as SceneWarning.)");
  scene.def(
      "to_dict", [](const SceneValue& self) { return object_of(self.document()); },
      "The dictionary that from_dict reads as the same scene again, doubles to the last bit.");
}

void bind_additions(SceneClass& scene) {
  scene.def("add_light", &add_to<lights_key>, py::arg("name"), py::arg("vertices") = py::none(),
            py::arg("facets") = py::none(), py::kw_only(), py::arg("shape") = py::none(),
            R"(Adds a light.

vertices: (n, 3) or, in the plane, (n, 2) numbers in the scene's unit of length. Two
are a segment; more a polygon, counterclockwise seen from the side to which it
shines; with facets, lists of indices of vertices, a closed convex mesh that shines
outward. All other keys are those of a light in a scene file: position=, direction=,
radiance= [W/(m^2 sr)], intensity_per_length= [W/(sr m)], intensity= [W/sr],
irradiance= [W/m^2], color=, two_sided=, holes=, emission=, ... and shape=, where
there is a choice. Raises SceneError and adds nothing if the light makes no sense.)");
  scene.def("add_blocker", &add_to<blockers_key>, py::arg("name"), py::arg("vertices") = py::none(),
            py::arg("facets") = py::none(), py::kw_only(), py::arg("shape") = py::none(),
            R"(Adds a blocker, opaque from both sides.

vertices: (n, 3) numbers, a convex polygon; with facets, lists of indices of vertices
((m, 3) for triangles), a mesh, which counts as filled if it is closed. shape="polytope"
is the convex hull of the vertices, shape="concave_polygon" any simple polygon. In the
plane (n, 2) numbers, a segment or a polyline. Other keys are those of a scene file.
Raises SceneError and adds nothing if the blocker makes no sense.)");
  scene.def("add_receiver", &add_to<receivers_key>, py::arg("name"), py::arg("vertices") = py::none(),
            py::arg("facets") = py::none(), py::kw_only(), py::arg("shape") = py::none(),
            R"(Adds a receiver: a surface whose shadows are asked for. It hides nothing.

Shapes are those of a blocker. It receives on the side from which the vertices run
counterclockwise, with two_sided=True on both.
Raises SceneError and adds nothing if the receiver makes no sense.)");
}

}  // namespace

void bind_scene(SceneClass& scene) {
  scene.doc() = R"(Lights, blockers and receivers with names, and what may be asked of them.

Coordinates are doubles and meant exactly; every decision is exact for them. Questions
may be asked from several threads at once; they run without the interpreter's lock.)";
  bind_ways_in(scene);
  bind_additions(scene);
  scene.def_property_readonly("light_names", &names_in<lights_key>, "The names of the lights.");
  scene.def_property_readonly("blocker_names", &names_in<blockers_key>, "The names of the blockers.");
  scene.def_property_readonly("receiver_names", &names_in<receivers_key>, "The names of the receivers.");
  scene.def_property_readonly(
      "dimension", [](const SceneValue& self) { return dimension(self.prepared()->scene()); }, "2 or 3.");
  scene.def_property_readonly(
      "length_unit", [](const SceneValue& self) { return facts(self.prepared()->scene()).length_unit; },
      "The unit of all coordinates, as \"m\".");
  scene.def_property_readonly("doubts", &doubts,
                              "What was accepted but is worth a word: a sentence each, as gnomon check prints them.");
  scene.def("__repr__", &text_of);
}

}  // namespace gnomon::python
