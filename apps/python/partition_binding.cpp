#include <pybind11/stl.h>

#include <algorithm>
#include <optional>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/element_choice.h"
#include "apps/python/arrays.h"
#include "apps/python/bindings.h"
#include "gnomon/flatland_partition.h"

namespace gnomon::python {
namespace {

/// A box of the plane, divided by what is seen of one light.
struct PartitionResult {
  std::string light;
  planar::Partition partition;
  planar::PartitionInBox in_box;
};

Box2 planar_box(const Scene& scene, const py::object& box) {
  if (box.is_none()) {
    const std::optional<Box3> usual = default_clip_box(scene);
    if (!usual) throw ArgumentError("box: found None, expected a box, as the scene has no usual one");
    return {{usual->min.x, usual->min.y}, {usual->max.x, usual->max.y}};
  }
  const Rows corners(box, "box", 2);
  const bool is_box =
      corners.count() == 2 && corners.at(0, 0) < corners.at(1, 0) && corners.at(0, 1) < corners.at(1, 1);
  if (!is_box) throw ArgumentError("box: found no two corners, expected the least and the greatest, apart in x and y");
  return {corners.planar_point(0), corners.planar_point(1)};
}

const PlanarLight& the_light(const PlaneScene& scene, const std::string& name) {
  const std::vector<const PlanarLight*> chosen = chosen_lights(scene.lights, name);
  if (chosen.size() == 1) return *chosen.front();
  throw ArgumentError("light: the scene has " + std::to_string(chosen.size()) + " lights, expected the name of one");
}

PartitionResult partition_of(const SceneValue& value, const std::string& light, const py::object& box, bool structure) {
  const std::shared_ptr<PreparedScene> scene = value.prepared();
  const auto* plane = std::get_if<PlaneScene>(&scene->scene());
  if (!plane) throw UnsupportedError(facts(scene->scene()).source + ": a partition needs a scene of dimension 2");
  const PlanarLight& of = the_light(*plane, light);
  const planar::PartitionOptions options{structure ? planar::Fineness::structure : planar::Fineness::regions,
                                         planar_box(scene->scene(), box)};
  const py::gil_scoped_release release;
  planar::Partition divided = planar::partition(planar_visibility(*plane, of), options);
  planar::PartitionInBox drawn = planar::partition_in_box(divided);
  return {of.name, std::move(divided), std::move(drawn)};
}

py::array_t<double> planar_vertices(const PartitionResult& result) {
  const std::vector<Point2>& points = result.partition.vertices();
  auto array = new_array<double>(points.size(), 2);
  if (!points.empty()) std::memcpy(array.mutable_data(), points.data(), points.size() * sizeof(Point2));
  return array;
}

/// Two numbers of every edge, -1 for nowhere.
template <class Pair>
py::array_t<std::int64_t> of_planar_edges(const PartitionResult& result, const Pair& pair) {
  const auto number = [](std::uint32_t n) { return n == planar::nowhere ? -1 : std::int64_t{n}; };
  auto array = new_array<std::int64_t>(result.partition.edges().size(), 2);
  std::int64_t* next = array.mutable_data();
  for (const planar::PartitionEdge& edge : result.partition.edges()) {
    const auto [first, second] = pair(edge);
    *next++ = number(first);
    *next++ = number(second);
  }
  return array;
}

py::array_t<std::uint8_t> planar_regions(const PartitionResult& result) {
  py::array_t<std::uint8_t> array(static_cast<py::ssize_t>(result.partition.faces().size()));
  std::uint8_t* next = array.mutable_data();
  for (const planar::PartitionFace& face : result.partition.faces()) *next++ = static_cast<std::uint8_t>(face.region);
  return array;
}

py::object planar_area(const ExactNumber& area, bool exact) {
  return exact ? fraction(area.exact) : py::object(py::float_(area.nearest));
}

py::dict planar_areas(const PartitionResult& result, bool exact) {
  const py::object type = py::module_::import("gnomon.regions").attr("Region");
  py::dict dict;
  for (std::size_t k = 0; k < result.in_box.areas.size(); ++k)
    dict[type(k)] = planar_area(result.in_box.areas[k], exact);
  return dict;
}

py::list planar_face_areas(const PartitionResult& result) {
  py::list list;
  for (const planar::FaceInBox& face : result.in_box.faces) list.append(planar_area(face.area, true));
  return list;
}

/// Points are the vertices.
py::tuple planar_triangles(const PartitionResult& result) {
  std::vector<std::array<std::uint32_t, 3>> corners;
  py::array_t<std::uint32_t> faces(static_cast<py::ssize_t>(result.in_box.triangles.size()));
  std::uint32_t* next = faces.mutable_data();
  for (const planar::FaceTriangle& triangle : result.in_box.triangles) {
    corners.push_back(triangle.corners);
    *next++ = triangle.face;
  }
  return py::make_tuple(planar_vertices(result), index_array<3>(corners), faces);
}

}  // namespace

void bind_partition(py::module_& module, SceneClass& scene) {
  py::class_<PartitionResult> partition_class(module, "Partition",
                                              R"(A box of the plane, divided exactly by what is seen of one light.

Labels, structure and areas are exact; coordinates are rounded once.)");
  bind_to_vtk(partition_class);
  partition_class.def_readonly("light", &PartitionResult::light, "The name of the light.")
      .def("vertices", &planar_vertices, "(v, 2): each coordinate correctly rounded.")
      .def(
          "edges",
          [](const PartitionResult& r) {
            return of_planar_edges(r, [](const auto& e) { return std::pair(e.source, e.target); });
          },
          "(e, 2): the vertices at both ends of each edge.")
      .def(
          "edge_faces",
          [](const PartitionResult& r) {
            return of_planar_edges(r, [](const auto& e) { return std::pair(e.left, e.right); });
          },
          "(e, 2): the faces on its left and right; -1 outside the box.")
      .def("face_regions", &planar_regions,
           "(faces,) of uint8: what each face receives, as gnomon.Region; decided exactly.")
      .def(
          "areas", [](const PartitionResult& r) { return planar_areas(r, false); },
          "Of lit, penumbra and umbra the area as the nearest double, in the unit of length squared.")
      .def(
          "exact_areas", [](const PartitionResult& r) { return planar_areas(r, true); },
          "The same as fractions.Fraction.")
      .def("exact_face_areas", &planar_face_areas, "The area of each face as a fractions.Fraction.")
      .def("triangles", &planar_triangles,
           "Points (v, 2), triangles (t, 3), counterclockwise, and the face of each (t,).")
      .def("__repr__", [](const PartitionResult& r) {
        return "<gnomon.Partition under '" + r.light + "': " + std::to_string(r.partition.faces().size()) + " faces>";
      });
  scene.def("partition", &partition_of, py::arg("light") = "", py::kw_only(), py::arg("box") = py::none(),
            py::arg("structure") = false,
            R"(The plane behind all blockers together, divided by what is seen of one light.

light: its name; needed where the scene has several. box: its least and its greatest
corner, (2, 2); without it the bounding box of the scene, grown on every side by half its
diagonal. structure: faces also differ in what is visible by name, so that the visible
fraction is one formula in each.
Returns Partition. Raises ArgumentError; UnsupportedError for a scene of dimension 3.)");
}

}  // namespace gnomon::python
