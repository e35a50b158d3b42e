#include "apps/gnomon/element_choice.h"
#include "apps/python/arrays.h"
#include "apps/python/asking.h"
#include "apps/python/bindings.h"

namespace gnomon::python {
namespace {

/// Results of regions(): rows are points, columns lights.
struct RegionsResult {
  py::tuple lights;
  py::array points;
  py::array_t<std::uint8_t> region;
  py::array_t<double> visible_fraction, error_bound;
  py::object before_receiver;  ///< an array, or None without normals
};

/// Results of irradiance().
struct IrradianceResult {
  py::tuple lights;
  py::array points;
  py::array_t<double> irradiance, error_bound;
};

/// Points without normals.
struct Bare {};

/// Where answers are written: row by row.
struct RegionRows {
  std::uint8_t* region;
  double* fraction;
  double* bound;
  double* before;

  void set(std::size_t i, const Visibility& seen) const {
    region[i] = static_cast<std::uint8_t>(seen.region);
    fraction[i] = seen.fraction;
    bound[i] = seen.error_bound;
    if (before) before[i] = seen.before_receiver;
  }
};

RegionsResult empty_regions(const py::tuple& lights, const Rows& points, bool of_receivers) {
  const std::size_t n = points.count(), columns = lights.size();
  RegionsResult result{lights,
                       points.array(),
                       new_array<std::uint8_t>(n, columns),
                       new_array<double>(n, columns),
                       new_array<double>(n, columns),
                       py::none()};
  if (of_receivers) result.before_receiver = new_array<double>(n, columns);
  return result;
}

RegionRows rows_of(RegionsResult& result) {
  double* before = result.before_receiver.is_none()
                       ? nullptr
                       : py::reinterpret_borrow<py::array_t<double>>(result.before_receiver).mutable_data();
  return {result.region.mutable_data(), result.visible_fraction.mutable_data(), result.error_bound.mutable_data(),
          before};
}

/// With or without normals.
template <class Receivers>
RegionsResult regions_in_space(PreparedScene& scene, const Rows& points, const Receivers& receivers,
                               const std::string& light, unsigned asked_threads) {
  constexpr bool of_receivers = std::is_same_v<Receivers, ReceiverArrays>;
  AskedLights& lights = scene.lights(light);
  const PreparedObstacles& obstacles = scene.obstacles();
  RegionsResult result = empty_regions(lights.names, points, of_receivers);
  const RegionRows rows = rows_of(result);
  const auto make = [&] {
    auto made = std::make_unique<std::vector<PartsVisibility>>();
    for (const LightGroup& group : lights.groups) made->emplace_back(shapes_of(group), obstacles);
    return made;
  };
  ask(lights.visibilities, points.count(), threads_for(points.count(), asked_threads), make,
      [&](std::size_t i, std::vector<PartsVisibility>& worker) {
        if constexpr (of_receivers) {
          const ReceiverPoint receiver = receivers.receiver(obstacles, i);
          for (std::size_t l = 0; l < worker.size(); ++l) rows.set(i * worker.size() + l, worker[l].received(receiver));
        } else {
          for (std::size_t l = 0; l < worker.size(); ++l)
            rows.set(i * worker.size() + l, worker[l].at(points.point(i)));
        }
      });
  return result;
}

RegionsResult regions_in_plane(const PlaneScene& scene, const Rows& points, const std::string& light,
                               unsigned threads) {
  std::vector<planar::LightVisibility> visibilities;
  py::list names;
  for (const PlanarLight* l : chosen_lights(scene.lights, light)) {
    names.append(l->name);
    visibilities.push_back(planar_visibility(scene, *l));
  }
  RegionsResult result = empty_regions(names, points, false);
  const RegionRows rows = rows_of(result);
  without_lock(points.count(), threads_for(points.count(), threads), [&](std::size_t i, std::size_t) {
    for (std::size_t l = 0; l < visibilities.size(); ++l) {
      const planar::VisibleLight seen = visibilities[l].visible_light(points.planar_point(i));
      const planar::VisibleFraction fraction = visible_fraction(seen);
      rows.set(i * visibilities.size() + l, {seen.region, fraction.value, fraction.error});
    }
  });
  return result;
}

RegionsResult regions(const SceneValue& value, const py::object& points, const py::object& normals,
                      const std::string& light, unsigned threads) {
  const std::shared_ptr<PreparedScene> scene = value.prepared();
  if (const auto* plane = std::get_if<PlaneScene>(&scene->scene())) {
    if (!normals.is_none()) throw ArgumentError("normals: found some, expected None in a scene of dimension 2");
    return regions_in_plane(*plane, Rows(points, "points", 2), light, threads);
  }
  if (normals.is_none()) return regions_in_space(*scene, Rows(points, "points", 3), Bare{}, light, threads);
  const ReceiverArrays receivers(points, normals);
  return regions_in_space(*scene, receivers.points, receivers, light, threads);
}

/// Calls `set(l, e)` for every light l with what it gives to a receiver; a light of parts gives what these do together.
template <class Set>
void receive(const AskedLights& lights, const LengthUnit& unit, std::vector<LightIrradiance>& worker,
             const ReceiverPoint& receiver, const Point3& normal, const Set& set) {
  const auto received = [&](std::size_t part) {
    return per_square_metre(worker[part].received(receiver, normal), lights.parts[part]->shape, unit);
  };
  if (lights.parts.size() == lights.groups.size()) {
    for (std::size_t l = 0; l < worker.size(); ++l) set(l, received(l));
    return;
  }
  std::vector<Irradiance> of_parts;
  for (std::size_t part = 0; part < worker.size(); ++part) of_parts.push_back(received(part));
  const std::vector<Irradiance> of_groups = irradiance_of_groups(lights.groups, of_parts);
  for (std::size_t l = 0; l < of_groups.size(); ++l) set(l, of_groups[l]);
}

IrradianceResult irradiance(const SceneValue& value, const py::object& points, const py::object& normals,
                            const std::string& light, unsigned threads) {
  const std::shared_ptr<PreparedScene> scene = value.prepared();
  const LengthUnit unit = *length_unit_named(scene->space("irradiance").length_unit);
  const ReceiverArrays at(points, normals);
  AskedLights& lights = scene->lights(light);
  const PreparedObstacles& obstacles = scene->obstacles();
  const std::size_t columns = lights.groups.size();
  IrradianceResult result{lights.names, at.points.array(), new_array<double>(at.count(), columns),
                          new_array<double>(at.count(), columns)};
  double* values = result.irradiance.mutable_data();
  double* bounds = result.error_bound.mutable_data();
  const auto make = [&] {
    auto made = std::make_unique<std::vector<LightIrradiance>>();
    for (const SceneLight* part : lights.parts) made->emplace_back(part->shape, part->strength, obstacles);
    return made;
  };
  ask(lights.irradiances, at.count(), threads_for(at.count(), threads), make,
      [&](std::size_t i, std::vector<LightIrradiance>& worker) {
        receive(lights, unit, worker, at.receiver(obstacles, i), at.normals.point(i),
                [&](std::size_t l, const Irradiance& e) {
                  values[i * columns + l] = e.value;
                  bounds[i * columns + l] = e.error_bound;
                });
      });
  return result;
}

/// What all lights together give, and bounds: two arrays of n numbers.
py::tuple total(const IrradianceResult& result) {
  const auto n = static_cast<std::size_t>(result.irradiance.shape(0));
  const auto columns = static_cast<std::size_t>(result.irradiance.shape(1));
  py::array_t<double> values(static_cast<py::ssize_t>(n)), bounds(static_cast<py::ssize_t>(n));
  std::vector<Irradiance> row(columns);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t l = 0; l < columns; ++l) {
      row[l] = {result.irradiance.data()[i * columns + l], result.error_bound.data()[i * columns + l]};
    }
    const Irradiance sum = total_irradiance(row);
    values.mutable_data()[i] = sum.value;
    bounds.mutable_data()[i] = sum.error_bound;
  }
  return py::make_tuple(values, bounds);
}

void bind_results(py::module_& module) {
  py::class_<RegionsResult> regions_class(module, "Regions",
                                          R"(What points receive of each light: rows are points, columns lights.)");
  bind_to_vtk(regions_class);
  regions_class.def_readonly("lights", &RegionsResult::lights, "Names of the columns.")
      .def_readonly("points", &RegionsResult::points, "(n, 3), or (n, 2) in the plane: the points that were asked.")
      .def_readonly("region", &RegionsResult::region,
                    "(n, lights) of uint8, decided exactly: 0 lit, 1 penumbra, 2 umbra, 3 unlit, as gnomon.Region.")
      .def_readonly("visible_fraction", &RegionsResult::visible_fraction,
                    "(n, lights): the visible share of the light.")
      .def_readonly("error_bound", &RegionsResult::error_bound, "(n, lights): at least |visible_fraction - exact|.")
      .def_readonly("before_receiver", &RegionsResult::before_receiver,
                    "(n, lights): the share of the light before the receiver's plane; None without normals.");
  py::class_<IrradianceResult> irradiance_class(
      module, "Irradiance", R"(What receivers get of each light: rows are points, columns lights.)");
  bind_to_vtk(irradiance_class);
  irradiance_class.def_readonly("lights", &IrradianceResult::lights, "Names of the columns.")
      .def_readonly("points", &IrradianceResult::points, "(n, 3): the points that were asked.")
      .def_readonly("irradiance", &IrradianceResult::irradiance,
                    "(n, lights) in W/m^2, whatever the scene's unit of length.")
      .def_readonly("error_bound", &IrradianceResult::error_bound,
                    "(n, lights): at least |irradiance - exact|, every rounding included.")
      .def("total", &total, R"(The irradiance of all lights together, and its error bound: two arrays of n numbers.)");
}

}  // namespace

void bind_points(py::module_& module, SceneClass& scene) {
  bind_results(module);
  scene.def("regions", &regions, py::arg("points"), py::arg("normals") = py::none(), py::kw_only(),
            py::arg("light") = "", py::arg("threads") = 0,
            R"(What points receive of each light behind all blockers together.

points: (n, 3) finite numbers in the scene's unit of length, (n, 2) in the plane.
normals: (n, 3) directions of any length, or None. With normals the points are those
of receivers: of a light only what lies before the receiver counts, and a facet right
under a point, up to rounding, does not hide the light from it.
light: only the light of that name. threads: 0 is one per processor.
An array of doubles is read where it lies, whatever its strides.
Returns Regions. Raises ArgumentError for wrong shapes, numbers that are not finite,
and names that the scene does not have.)");
  scene.def("irradiance", &irradiance, py::arg("points"), py::arg("normals"), py::kw_only(), py::arg("light") = "",
            py::arg("threads") = 0,
            R"(How much each light gives to receivers behind all blockers together [W/m^2].

points: (n, 3) finite numbers in the scene's unit of length. normals: (n, 3) directions
of any length, to the side that receives; what is behind them counts nothing. A facet
right under a point, up to rounding, does not hide the light from it.
light: only the light of that name. threads: 0 is one per processor.
An array of doubles is read where it lies, whatever its strides.
Returns Irradiance; |irradiance - exact| is at most error_bound. Raises ArgumentError
for wrong shapes, numbers that are not finite, normals that are zero, and names that
the scene does not have; UnsupportedError for a scene of dimension 2.)");
}

}  // namespace gnomon::python
