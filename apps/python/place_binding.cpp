#include <pybind11/stl/filesystem.h>

#include <optional>

#include "apps/gnomon/commands.h"
#include "apps/gnomon/design_output.h"
#include "apps/python/arrays.h"
#include "apps/python/bindings.h"
#include "apps/python/document.h"
#include "gnomon/light_design.h"

namespace gnomon::python {
namespace {

Point3 point_called(const char* name, const py::object& point) {
  return Rows(py::module_::import("numpy").attr("atleast_2d")(point), name, 3).point(0);
}

DesignEffort design_effort(const std::string& choose, const py::object& near, std::size_t most_cells) {
  DesignEffort effort;
  effort.most_cells = most_cells;
  if (choose == "centre") {
    effort.choice = Choice::centre;
  } else if (choose == "cube") {
    effort.choice = Choice::cube;
  } else if (choose == "nearest") {
    effort.choice = Choice::nearest;
  } else if (choose == "brightest") {
    effort.choice = Choice::brightest;
  } else {
    throw ArgumentError("choose: found '" + choose + "', expected centre, cube, nearest or brightest");
  }
  if ((effort.choice == Choice::nearest) == near.is_none()) {
    throw ArgumentError("choose='nearest' and near=(x, y, z) go together");
  }
  if (!near.is_none()) effort.near = point_called("near", near);
  return effort;
}

Design design_of(const py::object& goals, const SpaceScene& scene) {
  if (py::isinstance<py::dict>(goals)) return parse_design(json_of(goals, "").dump(), "goals", scene);
  std::filesystem::path file;
  try {
    file = goals.cast<std::filesystem::path>();
  } catch (const py::cast_error&) {
    throw ArgumentError("goals: expected a dictionary, or the name of a goals file");
  }
  return read_design(file, scene);
}

py::object place(const SceneValue& value, const py::object& goals, const std::string& choose, const py::object& near,
                 const py::object& check, std::size_t most_cells) {
  const std::shared_ptr<PreparedScene> scene = value.prepared();
  const SpaceScene& space = scene->space("placing a light");
  const DesignEffort effort = design_effort(choose, near, most_cells);
  const Design design = design_of(goals, space);
  if (design.variable == FreeVariable::direction && effort.choice != Choice::centre) {
    throw ArgumentError("choose: a direction has no cube and is near to no point, expected centre");
  }
  const std::optional<Point3> position = check.is_none() ? std::nullopt : std::optional(point_called("check", check));
  nlohmann::ordered_json json;
  try {
    const py::gil_scoped_release release;
    const DesignObstacles obstacles = design_obstacles(space);
    const DesignResult result =
        position ? checked_design(design, obstacles, *position) : solved_design(design, obstacles, effort);
    json = design_json({space, design, obstacles, result, position.has_value()});
  } catch (const DesignError& error) {
    throw UnsupportedError(std::string("goals: ") + error.what());
  }
  return object_of(json);
}

}  // namespace

void bind_place(SceneClass& scene) {
  scene.def("place", &place, py::arg("goals"), py::kw_only(), py::arg("choose") = "centre",
            py::arg("near") = py::none(), py::arg("check") = py::none(), py::arg("most_cells") = 10000,
            R"(Where a light, or a blocker, may stand so that goals are fulfilled.

goals: a dictionary with the keys of a goals file, or the name of such a file.
choose: which of all feasible positions is the answer: "centre", "cube", "nearest" (with
near=(x, y, z)) or "brightest". check: a position; only what becomes of the goals there
is told. most_cells: more are refused.
Returns what gnomon place prints with --json, a dictionary of schema gnomon/place/1:
"status", "answer", "goals", "conflict", "cells", ... Raises SceneError for goals that
make no sense, ArgumentError, UnsupportedError.)");
}

}  // namespace gnomon::python
