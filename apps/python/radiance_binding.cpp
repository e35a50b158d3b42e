#include <algorithm>

#include "apps/python/asking.h"
#include "apps/python/bindings.h"
#include "shading/image/scene_radiance.h"

namespace gnomon::python {
namespace {

/// Results of radiance(): rows are points, columns lights, layers red, green and blue.
struct RadianceResult {
  py::tuple lights;
  py::array points;
  py::array_t<double> radiance, error_bound, ambient, ambient_error_bound;
};

/// Where eyes are: one for every point, or the same for all.
class Eyes {
 public:
  Eyes(const py::object& eyes, const Rows& points) : rows_(as_rows(eyes), "eyes", 3) {
    if (rows_.count() != 1) rows_.require_count(points);
  }

  Point3 at(std::size_t i) const { return rows_.point(rows_.count() == 1 ? 0 : i); }

 private:
  /// Three numbers are one eye.
  static py::object as_rows(const py::object& eyes) {
    if (!py::isinstance<py::sequence>(eyes) && !py::isinstance<py::array>(eyes)) return eyes;
    return py::module_::import("numpy").attr("atleast_2d")(eyes);
  }

  Rows rows_;
};

const Material& material_called(const SpaceScene& scene, const std::string& name) {
  static const Material grey;
  if (name.empty()) {
    if (scene.materials.size() > 1)
      throw ArgumentError("material: the scene has several materials, expected the name of one");
    return scene.materials.empty() ? grey : scene.materials.front().material;
  }
  const auto found = std::ranges::find(scene.materials, name, &SceneMaterial::name);
  if (found != scene.materials.end()) return found->material;
  std::vector<std::string> known;
  for (const SceneMaterial& material : scene.materials) known.push_back(material.name);
  throw ArgumentError("material: the scene has no material '" + name + "'; it has " + listed_names(known));
}

/// Half of the way from a point to another, which does not overflow.
Point3 way_to(const Point3& from, const Point3& to) {
  return {to.x / 2 - from.x / 2, to.y / 2 - from.y / 2, to.z / 2 - from.z / 2};
}

py::array_t<double> colours(std::size_t rows, std::size_t columns) {
  return py::array_t<double>({static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(columns), py::ssize_t{3}});
}

RadianceResult no_radiance(const AskedLights& lights, const Rows& points) {
  const std::size_t n = points.count(), columns = lights.groups.size();
  RadianceResult result{lights.names,        points.array(),          colours(n, columns),
                        colours(n, columns), new_array<double>(n, 3), new_array<double>(n, 3)};
  for (py::array_t<double>* array :
       {&result.radiance, &result.error_bound, &result.ambient, &result.ambient_error_bound}) {
    std::fill_n(array->mutable_data(), array->size(), 0.0);
  }
  return result;
}

void set(double* values, double* bounds, std::size_t place, const RadianceRgb& seen) {
  for (std::size_t k = 0; k < 3; ++k) {
    values[3 * place + k] = seen[k].value;
    bounds[3 * place + k] = seen[k].error_bound;
  }
}

/// A question of radiance: everything that does not change from point to point.
struct Seen {
  const AskedLights& lights;
  const Material& material;
  LengthUnit unit;

  std::vector<RadianceRgb> of_groups(std::vector<LightReflection>& worker, const ReceiverPoint& receiver,
                                     const View& view) const {
    std::vector<RadianceRgb> of_parts;
    for (std::size_t l = 0; l < worker.size(); ++l) {
      const Reflection r = worker[l].received(receiver, view, material.model, material.exponent);
      of_parts.push_back(reflected_radiance(*lights.parts[l], r, material, unit));
    }
    return radiance_of_groups(lights.groups, of_parts);
  }
};

RadianceResult radiance(const SceneValue& value, const py::object& points, const py::object& normals,
                        const py::object& eyes, const std::string& material, const std::string& light,
                        unsigned threads) {
  const std::shared_ptr<PreparedScene> scene = value.prepared();
  const SpaceScene& space = scene->space("radiance");
  const ReceiverArrays at(points, normals);
  const Eyes looking(eyes, at.points);
  AskedLights& lights = scene->lights(light);
  const PreparedObstacles& obstacles = scene->obstacles();
  const Seen seen{lights, material_called(space, material), *length_unit_named(space.length_unit)};
  const RadianceRgb ambient = ambient_radiance(seen.material, space.ambient_radiance);
  RadianceResult result = no_radiance(lights, at.points);
  double* values = result.radiance.mutable_data();
  double* bounds = result.error_bound.mutable_data();
  double* ambient_values = result.ambient.mutable_data();
  double* ambient_bounds = result.ambient_error_bound.mutable_data();
  const auto make = [&] {
    auto made = std::make_unique<std::vector<LightReflection>>();
    for (const SceneLight* part : lights.parts) made->emplace_back(part->shape, obstacles);
    return made;
  };
  ask(lights.reflections, at.count(), threads_for(at.count(), threads), make,
      [&](std::size_t i, std::vector<LightReflection>& worker) {
        const Point3 p = at.points.point(i), eye = looking.at(i);
        if (eye == p) return;
        const View view{p, at.normals.point(i), way_to(p, eye)};
        const std::vector<RadianceRgb> of_groups = seen.of_groups(worker, at.receiver(obstacles, i), view);
        for (std::size_t l = 0; l < of_groups.size(); ++l) set(values, bounds, i * of_groups.size() + l, of_groups[l]);
        if (eye_is_above(view)) set(ambient_values, ambient_bounds, i, ambient);
      });
  return result;
}

/// What all lights and ambient light together give, and bounds: two arrays of shape (n, 3).
py::tuple total_of_all(const RadianceResult& result) {
  const auto n = static_cast<std::size_t>(result.radiance.shape(0));
  const auto columns = static_cast<std::size_t>(result.radiance.shape(1));
  auto values = new_array<double>(n, 3), bounds = new_array<double>(n, 3);
  std::vector<RadianceRgb> row(columns + 1);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < columns; ++l) {
        const std::size_t place = 3 * (i * columns + l) + k;
        row[l][k] = {result.radiance.data()[place], result.error_bound.data()[place]};
      }
      row[columns][k] = {result.ambient.data()[3 * i + k], result.ambient_error_bound.data()[3 * i + k]};
    }
    set(values.mutable_data(), bounds.mutable_data(), i, total_radiance(row));
  }
  return py::make_tuple(values, bounds);
}

}  // namespace

void bind_radiance(py::module_& module, SceneClass& scene) {
  py::class_<RadianceResult> radiance_class(
      module, "Radiance", "What surfaces reflect of each light: rows are points, columns lights, then r, g, b.");
  bind_to_vtk(radiance_class);
  radiance_class.def_readonly("lights", &RadianceResult::lights, "Names of the columns.")
      .def_readonly("points", &RadianceResult::points, "(n, 3): the points that were asked.")
      .def_readonly("radiance", &RadianceResult::radiance, "(n, lights, 3) in W/(m^2 sr), linear red, green and blue.")
      .def_readonly("error_bound", &RadianceResult::error_bound, "(n, lights, 3): at least |radiance - exact|.")
      .def_readonly("ambient", &RadianceResult::ambient,
                    "(n, 3): what is reflected of light that comes from everywhere.")
      .def_readonly("ambient_error_bound", &RadianceResult::ambient_error_bound, "(n, 3): its error bound.")
      .def("total", &total_of_all,
           "The radiance of all lights and of ambient light together, and its error bound: (n, 3) each.");
  scene.def("radiance", &radiance, py::arg("points"), py::arg("normals"), py::arg("eyes"), py::kw_only(),
            py::arg("material") = "", py::arg("light") = "", py::arg("threads") = 0,
            R"(What surfaces reflect of each light, behind all blockers together, to an eye [W/(m^2 sr)].

points, normals: as of irradiance. eyes: (n, 3) places of an eye for each point, or
three numbers, the same eye for all.
material: the name of one of the scene's, which the points are made of; without it the
scene's only one, or a diffuse grey of 0.5 where it has none.
light: only the light of that name. threads: 0 is one per processor.
Returns Radiance; |radiance - exact| is at most error_bound, for the direction to the
eye as the difference of the two points rounded to doubles. Where the eye is not above
the point's plane it is 0. Raises ArgumentError and UnsupportedError as irradiance.)");
}

}  // namespace gnomon::python
