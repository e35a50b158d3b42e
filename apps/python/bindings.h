#pragma once

/// The parts of the module, each in a file of its own.

#include <pybind11/pybind11.h>

#include "apps/python/scene_value.h"

namespace gnomon::python {

/// Warns of what is worth a word, by a SceneWarning. Throws: error_already_set where warnings are errors.
void warn(const std::string& sentence);

using SceneClass = pybind11::class_<SceneValue>;

void bind_errors(pybind11::module_& module);
void bind_scene(SceneClass& scene);
void bind_points(pybind11::module_& module, SceneClass& scene);
void bind_radiance(pybind11::module_& module, SceneClass& scene);
void bind_receivers(pybind11::module_& module, SceneClass& scene);
void bind_pair(pybind11::module_& module, SceneClass& scene);
void bind_view_factors(pybind11::module_& module, SceneClass& scene);
void bind_place(SceneClass& scene);
void bind_illumination(pybind11::module_& module, SceneClass& scene);
void bind_partition(pybind11::module_& module, SceneClass& scene);

}  // namespace gnomon::python
