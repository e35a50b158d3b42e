#include <pybind11/stl.h>

#include <optional>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/receiver_rows.h"
#include "apps/python/arrays.h"
#include "apps/python/bindings.h"
#include "apps/python/long_work.h"
#include "geometry/scene/receiver_facets.h"
#include "geometry/scene/scene_points.h"
#include "gnomon/illumination.h"
#include "gnomon/receiver_mesh.h"

namespace gnomon::python {
namespace {

/// A flat receiver in faces.
struct IlluminatedReceiver {
  py::tuple lights;
  std::string name;
  IlluminationMesh mesh;
};

/// Throws: UnsupportedError for what receivers are not divided by.
void require_illuminable(const SpaceScene& scene, const AskedLights& lights, const SceneBodies& bodies) {
  const auto require = [&](std::string_view refusal, const std::string& what, const char* between) {
    if (!refusal.empty()) throw UnsupportedError(scene.source + ": " + what + between + std::string(refusal));
  };
  for (const SceneLight* part : lights.parts) {
    require(range_refusal(part->shape), "light '" + part->element + "'", " ");
    require(division_refusal(part->shape, bodies.obstacles.enclosures), "light '" + part->element + "'", ": ");
  }
  for (const SceneBlocker& blocker : scene.blockers) {
    require(range_refusal(blocker_points(blocker.shape)), "blocker '" + blocker.name + "'", " ");
  }
  for (const SceneReceiver& receiver : scene.receivers) {
    require(range_refusal(receiver.shape.points()), "receiver '" + receiver.side + "'", " ");
  }
}

IlluminationEffort illumination_effort(const std::optional<double>& tolerance, double relative, int order,
                                       const std::string& split) {
  IlluminationEffort effort;
  effort.is_relative = !tolerance;
  effort.tolerance = tolerance.value_or(relative);
  if (!(effort.tolerance > 0)) throw ArgumentError("tolerance, relative: expected a number larger than 0");
  if (order != 1 && order != 2) throw ArgumentError("order: found " + std::to_string(order) + ", expected 1 or 2");
  effort.order = order;
  if (split == "need") {
    effort.split = IlluminationSplit::need;
  } else if (split == "all") {
    effort.split = IlluminationSplit::all;
  } else if (split == "none") {
    effort.split = IlluminationSplit::none;
  } else {
    throw ArgumentError("split: found '" + split + "', expected need, all or none");
  }
  return effort;
}

py::list illuminate_scene(const SceneValue& value, const std::optional<double>& tolerance, double relative,
                          const std::string& receiver, const std::string& light, int order, const std::string& split,
                          std::size_t most_faces, unsigned threads) {
  const std::shared_ptr<PreparedScene> scene = value.prepared();
  const SpaceScene& space = scene->space("illumination meshes");
  IlluminationEffort effort = illumination_effort(tolerance, relative, order, split);
  effort.most_faces = most_faces;
  effort.threads = checked_threads(threads);
  effort.unit = *length_unit_named(space.length_unit);
  require_receiver("receiver", receiver, space.receivers);
  const AskedLights& lights = scene->lights(light);
  const SceneBodies& bodies = scene->bodies();
  require_illuminable(space, lights, bodies);
  std::vector<IlluminationLight> shining;
  for (const LightGroup& group : lights.groups) shining.push_back({shapes_of(group), group.parts.front()->strength});
  std::vector<ConvexPolygon> shapes;
  std::vector<std::string> names;
  for (const ReceiverGroup side : receiver_sides(space.receivers)) {
    for (const SceneReceiver& facet : side) {
      if (!receiver.empty() && !facet.is_called(receiver)) continue;
      shapes.push_back(facet.shape);
      names.push_back(facet.name);
    }
  }
  Illumination found;
  {
    const py::gil_scoped_release release;
    found = illuminate(shining, bodies.obstacles, shapes, effort);
  }
  py::list result;
  for (std::size_t k = 0; k < names.size(); ++k) {
    result.append(py::cast(IlluminatedReceiver{lights.names, names[k], std::move(found.meshes[k])}));
  }
  return result;
}

template <class Value>
py::array_t<double> irradiance_column(const std::vector<Irradiance>& all, const Value& value) {
  py::array_t<double> column(static_cast<py::ssize_t>(all.size()));
  double* next = column.mutable_data();
  for (const Irradiance& e : all) *next++ = value(e);
  return column;
}

py::array_t<std::uint32_t> illuminated_faces(const IlluminatedReceiver& one) {
  if (one.mesh.order == 1) {
    std::vector<std::array<std::uint32_t, 3>> corners;
    for (const IlluminationFace& face : one.mesh.faces) corners.push_back(face.corners);
    return index_array<3>(corners);
  }
  std::vector<std::array<std::uint32_t, 6>> all;
  for (const IlluminationFace& face : one.mesh.faces) {
    const auto& [a, b, c] = face.corners;
    const auto& [ab, bc, ca] = face.middles;
    all.push_back({a, b, c, ab, bc, ca});
  }
  return index_array<6>(all);
}

py::array_t<double> face_errors(const IlluminatedReceiver& one) {
  py::array_t<double> errors(static_cast<py::ssize_t>(one.mesh.faces.size()));
  double* next = errors.mutable_data();
  for (const IlluminationFace& face : one.mesh.faces) *next++ = face.error;
  return errors;
}

using IlluminatedClass = py::class_<IlluminatedReceiver>;

void bind_illuminated(IlluminatedClass& illuminated) {
  illuminated
      .def_readonly("name", &IlluminatedReceiver::name, "The receiver, or its flat piece: \"floor\", \"vase#12\".")
      .def_readonly("lights", &IlluminatedReceiver::lights, "The names of the lights.")
      .def(
          "points", [](const IlluminatedReceiver& one) { return points_array(one.mesh.points); },
          "(p, 3): the points of the mesh; where irradiance may jump, each face has points of its own.")
      .def(
          "irradiance",
          [](const IlluminatedReceiver& one) {
            return irradiance_column(one.mesh.irradiance, [](const Irradiance& e) { return e.value; });
          },
          "(p,): of all lights together [W/m^2].")
      .def(
          "error_bound",
          [](const IlluminatedReceiver& one) {
            return irradiance_column(one.mesh.irradiance, [](const Irradiance& e) { return e.error_bound; });
          },
          "(p,): at least |irradiance - exact| at the points.")
      .def(
          "faces", &illuminated_faces,
          "(f, 3): points of each triangle, counterclockwise seen from the front; with order 2 (f, 6), the middles of\n"
          "its sides last.")
      .def("face_error", &face_errors, "(f,): an estimate of the largest error of interpolation in each face [W/m^2].")
      .def(
          "unmet_faces", [](const IlluminatedReceiver& one) { return one.mesh.unmet_faces(); },
          "How many faces did not get within the tolerance.")
      .def(
          "flux", [](const IlluminatedReceiver& one) { return std::pair(one.mesh.flux(), one.mesh.flux_error()); },
          "The integral of what is interpolated, and what it may be off by, an estimate [W, lengths in metres].")
      .def("__repr__", [](const IlluminatedReceiver& one) {
        return "<gnomon.IlluminatedReceiver '" + one.name + "': " + std::to_string(one.mesh.faces.size()) + " faces>";
      });
}

}  // namespace

void bind_illumination(py::module_& module, SceneClass& scene) {
  IlluminatedClass illuminated(module, "IlluminatedReceiver",
                               "A flat receiver in faces, whose irradiance is interpolated between their points.");
  bind_illuminated(illuminated);
  bind_to_vtk(illuminated);
  scene.def("illuminate", &illuminate_scene, py::kw_only(), py::arg("tolerance") = py::none(),
            py::arg("relative") = 0.01, py::arg("receiver") = "", py::arg("light") = "", py::arg("order") = 1,
            py::arg("split") = "need", py::arg("most_faces") = 1000000, py::arg("threads") = 0,
            R"(Meshes of receivers whose interpolated irradiance is within a tolerance everywhere.

tolerance: how far off it may be [W/m^2]; without it relative, a share of the largest
irradiance found. order: 1 for linear faces, 2 for quadratic ones. split: which
discontinuities of order 2 are edges: "need", "all" or "none". most_faces: of one
receiver, about. receiver, light: only those of that name.
Returns a list of IlluminatedReceiver. Points have bounds; errors of faces are estimates.
Raises ArgumentError and UnsupportedError.)");
}

}  // namespace gnomon::python
