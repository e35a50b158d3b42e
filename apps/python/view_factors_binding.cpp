#include <pybind11/stl.h>

#include <algorithm>
#include <optional>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/view_surfaces.h"
#include "apps/python/arrays.h"
#include "apps/python/bindings.h"
#include "apps/python/long_work.h"

namespace gnomon::python {
namespace {

/// Factors between the surfaces of a scene, with the names of these.
struct FactorsResult {
  std::vector<std::string> names;
  ViewFactors factors;
};

std::optional<std::uint32_t> surface_called(const std::string& name, const std::vector<std::string>& names) {
  if (name.empty()) return std::nullopt;
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<std::uint32_t>(found - names.begin());
  throw ArgumentError("source: found no surface '" + name + "', expected one of " + listed_names(names));
}

FactorsResult view_factors_of(const SceneValue& value, double bound, bool faces, const std::string& source, bool twice,
                              unsigned threads) {
  const std::shared_ptr<PreparedScene> scene = value.prepared();
  const SpaceScene& space = scene->space("view factors");
  if (!(bound > 0)) throw ArgumentError("bound: expected a number larger than 0");
  const SceneBodies& bodies = scene->bodies();
  const ViewSurfaces surfaces = faces ? blocker_surfaces(space, bodies) : receiver_surfaces(space);
  require_range(space, surfaces, bodies.obstacles);
  ViewFactorEffort effort;
  effort.bound = bound;
  effort.threads = checked_threads(threads);
  effort.from = surface_called(source, surfaces.names);
  effort.twice = twice;
  const py::gil_scoped_release release;
  return {surfaces.names, view_factors(surfaces.shapes, bodies.obstacles, effort)};
}

template <class Number, class Value>
py::array_t<Number> factor_column(const FactorsResult& result, const Value& value) {
  py::array_t<Number> column(static_cast<py::ssize_t>(result.factors.factors.size()));
  Number* next = column.mutable_data();
  for (const ViewFactor& factor : result.factors.factors) *next++ = value(factor);
  return column;
}

/// Factors and bounds of every surface to every other, zeros included.
py::tuple factor_matrix(const FactorsResult& result) {
  const std::size_t n = result.names.size();
  auto values = new_array<double>(n, n), bounds = new_array<double>(n, n);
  std::fill_n(values.mutable_data(), n * n, 0.0);
  std::fill_n(bounds.mutable_data(), n * n, 0.0);
  for (const ViewFactor& factor : result.factors.factors) {
    values.mutable_data()[factor.from * n + factor.to] = factor.value;
    bounds.mutable_data()[factor.from * n + factor.to] = factor.error_bound;
  }
  return py::make_tuple(values, bounds);
}

}  // namespace

void bind_view_factors(py::module_& module, SceneClass& scene) {
  py::class_<FactorsResult>(module, "ViewFactors", R"(The share of what each surface sends out that reaches each other.

Factors that are exactly 0 are left out; all of matrix() has them.)")
      .def_property_readonly(
          "surfaces", [](const FactorsResult& r) { return py::tuple(py::cast(r.names)); },
          "The names of the surfaces, which numbers in source and target count.")
      .def(
          "areas",
          [](const FactorsResult& r) {
            return py::array_t<double>(static_cast<py::ssize_t>(r.factors.areas.size()), r.factors.areas.data());
          },
          "(surfaces,): off by at most 4 ulp, in the unit of length squared.")
      .def(
          "source",
          [](const FactorsResult& r) {
            return factor_column<std::uint32_t>(r, [](const ViewFactor& f) { return f.from; });
          },
          "(k,): the surface that sends, of each factor.")
      .def(
          "target",
          [](const FactorsResult& r) {
            return factor_column<std::uint32_t>(r, [](const ViewFactor& f) { return f.to; });
          },
          "(k,): the surface that receives.")
      .def(
          "factor",
          [](const FactorsResult& r) { return factor_column<double>(r, [](const ViewFactor& f) { return f.value; }); },
          "(k,): the factors.")
      .def(
          "error_bound",
          [](const FactorsResult& r) {
            return factor_column<double>(r, [](const ViewFactor& f) { return f.error_bound; });
          },
          "(k,): at least |factor - exact| where is_proven() says so, elsewhere an estimate of it.")
      .def(
          "is_proven",
          [](const FactorsResult& r) {
            return factor_column<bool>(r, [](const ViewFactor& f) { return f.is_proven; });
          },
          "(k,): whether the error bound is proven.")
      .def("matrix", &factor_matrix, "Factors and error bounds as two arrays of shape (surfaces, surfaces).");
  scene.def("view_factors", &view_factors_of, py::kw_only(), py::arg("bound") = 1e-9, py::arg("faces") = false,
            py::arg("source") = "", py::arg("twice") = false, py::arg("threads") = 0,
            R"(View factors between surfaces behind all blockers together.

Surfaces are the sides of receivers; with faces=True the facets of blockers. bound: the
error that is wanted of every factor. source: only factors from the surface of that name.
twice: both of the two factors of a pair, each by itself. threads: 0 is one per processor.
Returns ViewFactors. Raises ArgumentError and UnsupportedError.)");
}

}  // namespace gnomon::python
