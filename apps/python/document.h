#pragma once

/// What scenes are written in: Python's objects as JSON, and back.

#include <pybind11/pybind11.h>

#include <nlohmann/json_fwd.hpp>

namespace gnomon::python {

/// Dictionaries with string keys, lists, tuples, arrays, strings, numbers, True, False, None.
///
/// Throws: ArgumentError for other objects, and for numbers that are not finite; it names the place from `place` on.
nlohmann::ordered_json json_of(pybind11::handle object, const std::string& place);

/// Dictionaries and lists of the same.
pybind11::object object_of(const nlohmann::ordered_json& json);

}  // namespace gnomon::python
