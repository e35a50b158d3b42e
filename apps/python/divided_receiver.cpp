#include "apps/python/divided_receiver.h"

#include <pybind11/stl.h>

#include "apps/python/arrays.h"

namespace gnomon::python {
namespace {

py::object region_object(std::size_t region) {
  return py::module_::import("gnomon.regions").attr("Region")(region);
}

py::array_t<std::uint32_t> edges(const DividedReceiver& one) {
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (const MeshEdge& edge : one.mesh.edges()) ends.push_back({edge.source, edge.target});
  return index_array<2>(ends);
}

py::array_t<std::int64_t> edge_faces(const DividedReceiver& one) {
  const auto face = [](std::uint32_t f) { return f == MeshEdge::nowhere ? -1 : std::int64_t{f}; };
  auto result = new_array<std::int64_t>(one.mesh.edges().size(), 2);
  std::int64_t* next = result.mutable_data();
  for (const MeshEdge& edge : one.mesh.edges()) {
    *next++ = face(edge.left);
    *next++ = face(edge.right);
  }
  return result;
}

py::array_t<std::uint8_t> face_regions(const DividedReceiver& one) {
  py::array_t<std::uint8_t> result(static_cast<py::ssize_t>(one.mesh.faces().size()));
  std::uint8_t* next = result.mutable_data();
  for (const MeshFace& face : one.mesh.faces()) *next++ = static_cast<std::uint8_t>(face.region);
  return result;
}

/// The vertices along each cycle of each part, faces or polygons; the first comes once.
template <class Parts>
py::list cycles_of(const ReceiverMesh& mesh, const Parts& parts) {
  py::list list;
  for (const auto& part : parts) {
    py::list cycles;
    for (const std::vector<MeshEdgeUse>& cycle : part.cycles) {
      py::array_t<std::uint32_t> vertices(static_cast<py::ssize_t>(cycle.size()));
      std::uint32_t* next = vertices.mutable_data();
      for (const MeshEdgeUse use : cycle) {
        const MeshEdge& edge = mesh.edges()[use / 2];
        *next++ = use % 2 == 0 ? edge.source : edge.target;
      }
      cycles.append(vertices);
    }
    list.append(cycles);
  }
  return list;
}

py::list polygons(const DividedReceiver& one) {
  const std::vector<RegionPolygon> regions = one.mesh.regions();
  const py::list cycles = cycles_of(one.mesh, regions);
  py::list result;
  for (std::size_t k = 0; k < regions.size(); ++k) {
    result.append(py::make_tuple(region_object(static_cast<std::size_t>(regions[k].region)), cycles[k]));
  }
  return result;
}

py::object element(const DividedReceiver& one, const EventElement& e) {
  const std::string of = e.of == EventOf::light      ? "light:" + one.light
                         : e.of == EventOf::receiver ? "receiver:" + one.receiver
                                                     : "blocker:" + (*one.blockers)[number(e.body)];
  return py::module_::import("gnomon.results").attr("Element")(of, number(e.index));
}

py::tuple events(const DividedReceiver& one) {
  const py::object type = py::module_::import("gnomon.results").attr("Event");
  py::list list;
  for (const EventName& event : one.mesh.names()) {
    py::list elements;
    elements.append(element(one, event.vertex));
    elements.append(element(one, event.edge));
    if (event.kind == EventKind::triple_edge) elements.append(element(one, event.third));
    const py::object order = event.kind == EventKind::border ? py::object(py::none()) : py::int_(event.order);
    list.append(type(std::string(name(event.kind)), py::tuple(elements), order, std::string(name(event.extremal))));
  }
  return list;
}

py::tuple edge_events(const DividedReceiver& one) {
  py::list list;
  for (const MeshEdge& edge : one.mesh.edges()) list.append(py::tuple(py::cast(edge.names)));
  return list;
}

py::tuple arcs_of(const DividedReceiver& one) {
  const py::object type = py::module_::import("gnomon.results").attr("Arc");
  const std::vector<MeshArc> arcs = one.mesh.arcs();
  py::list list;
  for (std::size_t e = 0; e < one.mesh.edges().size(); ++e) {
    const std::uint32_t arc = one.mesh.edges()[e].arc;
    if (arc == MeshEdge::nowhere) continue;
    const Point3& middle = arcs[arc].points[1];
    list.append(type(e, py::make_tuple(middle.x, middle.y, middle.z), arcs[arc].weight));
  }
  return list;
}

py::object exact_area(const RegionArea& area) {
  return area.exact ? fraction(*area.exact) : py::object(py::none());
}

py::dict areas(const DividedReceiver& one) {
  const auto all = one.mesh.areas();
  py::dict result;
  for (std::size_t k = 0; k < all.size(); ++k) result[region_object(k)] = all[k].nearest;
  return result;
}

py::dict exact_areas(const DividedReceiver& one) {
  const auto all = one.mesh.areas();
  py::dict result;
  for (std::size_t k = 0; k < all.size(); ++k) result[region_object(k)] = exact_area(all[k]);
  return result;
}

/// Points, triangles and the face of each.
py::tuple drawing(const DividedReceiver& one) {
  const MeshDrawing drawn = one.mesh.drawing();
  std::vector<std::array<std::uint32_t, 3>> corners;
  py::array_t<std::uint32_t> faces(static_cast<py::ssize_t>(drawn.triangles.size()));
  std::uint32_t* next = faces.mutable_data();
  for (const ReceiverTriangle& triangle : drawn.triangles) {
    corners.push_back(triangle.vertices);
    *next++ = triangle.face;
  }
  return py::make_tuple(points_array(drawn.points), index_array<3>(corners), faces);
}

py::object visible_fractions(const DividedReceiver& one) {
  if (one.fractions.empty()) return py::none();
  return py::array_t<double>(static_cast<py::ssize_t>(one.fractions.size()), one.fractions.data());
}

using DividedClass = py::class_<DividedReceiver>;

void bind_mesh(DividedClass& divided) {
  divided.def_readonly("light", &DividedReceiver::light, "The name of the light, or of its part.")
      .def_readonly("name", &DividedReceiver::receiver, "The receiver, or its flat piece: \"floor\", \"vase#12\".")
      .def_readonly("side", &DividedReceiver::side, "The receiver, or its side: \"vase\", \"vase/back\".")
      .def(
          "vertices", [](const DividedReceiver& one) { return points_array(one.mesh.vertices()); },
          "(v, 3): the mesh's vertices, each coordinate correctly rounded; at ends of arcs off by at most an ulp.")
      .def("edges", &edges, "(e, 2): the vertices at both ends of each edge.")
      .def("edge_faces", &edge_faces,
           "(e, 2): the faces left and right of each edge, seen from the front; -1 beyond the border.")
      .def("edge_events", &edge_events, "Of each edge, the indices in events() of what happens along it.")
      .def("arcs", &arcs_of, "The edges that are arcs of conics, each an Arc; all others are segments.")
      .def("events", &events, "The events of the mesh, each an Event.")
      .def(
          "faces", [](const DividedReceiver& one) { return cycles_of(one.mesh, one.mesh.faces()); },
          "Of each face its cycles of vertices, the face on their left: the outer one, then holes.")
      .def("face_regions", &face_regions,
           "(faces,) of uint8: what each face receives, as gnomon.Region; decided exactly.")
      .def("polygons", &polygons,
           "Connected faces of one region: pairs of a Region and cycles of vertices, as of faces.")
      .def("visible_fractions", &visible_fractions,
           "(v,): the visible fraction at each vertex, correctly rounded; None unless asked for with fractions=True.")
      .def("triangles", &drawing,
           R"(Points (p, 3), triangles (t, 3) and the face of each triangle (t,), to be drawn.

The first points are the mesh's vertices; others lie on arcs, for which chords stand.)");
}

void bind_areas(DividedClass& divided) {
  divided.def("areas", &areas, "Of each Region its area as the nearest double, in the unit of length squared.")
      .def("exact_areas", &exact_areas,
           "Of each Region its area as a fractions.Fraction; None where it is not rational.")
      .def(
          "area", [](const DividedReceiver& one) { return one.mesh.area().nearest; }, "The area of the whole, rounded.")
      .def(
          "exact_area", [](const DividedReceiver& one) { return exact_area(one.mesh.area()); },
          "The area of the whole as a fractions.Fraction; None where it is not rational.")
      .def("__repr__", [](const DividedReceiver& one) {
        return "<gnomon.DividedReceiver '" + one.receiver + "' under '" + one.light +
               "': " + std::to_string(one.mesh.faces().size()) + " faces>";
      });
}

}  // namespace

void bind_divided_receiver(py::module_& module) {
  DividedClass divided(module, "DividedReceiver",
                       R"(A flat receiver, divided exactly by all discontinuities of what it receives of one light.

The structure, the labels and areas without arcs are exact; coordinates are rounded once.)");
  bind_mesh(divided);
  bind_to_vtk(divided);
  bind_areas(divided);
}

}  // namespace gnomon::python
