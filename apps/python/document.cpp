#include "apps/python/document.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/python/arrays.h"

namespace gnomon::python {
namespace {

using Json = nlohmann::ordered_json;

/// Lists may hold themselves: as deep as Python itself goes, and no deeper.
class Depth {
 public:
  Depth() {
    if (Py_EnterRecursiveCall(" in what is to be a scene") != 0) throw py::error_already_set();
  }
  ~Depth() { Py_LeaveRecursiveCall(); }
  Depth(const Depth&) = delete;
  Depth& operator=(const Depth&) = delete;
};

Json text_json(py::handle text, const std::string& place) {
  py::ssize_t size = 0;
  const char* bytes = PyUnicode_AsUTF8AndSize(text.ptr(), &size);
  if (bytes != nullptr) return std::string(bytes, static_cast<std::size_t>(size));
  PyErr_Clear();
  throw ArgumentError(place + ": found a string that is no text, expected characters of Unicode");
}

Json number_json(py::handle number, const std::string& place) {
  const auto value = number.cast<double>();
  if (std::isfinite(value)) return value;
  throw ArgumentError(place + ": found " + py::str(number).cast<std::string>() + ", expected a finite number");
}

Json integer_json(py::handle number, const std::string& place) {
  int overflow = 0;
  const long long value = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow == 0) return value;
  const double nearest = PyLong_AsDouble(number.ptr());
  if (PyErr_Occurred() == nullptr) return nearest;
  PyErr_Clear();
  throw ArgumentError(place + ": found an integer that no double holds, expected a number");
}

Json list_json(py::handle list, const std::string& place) {
  Json json = Json::array();
  for (const py::handle item : list) json.push_back(json_of(item, place + '/' + std::to_string(json.size())));
  return json;
}

Json dict_json(const py::dict& dict, const std::string& place) {
  Json json = Json::object();
  for (const auto& [key, value] : dict) {
    if (!py::isinstance<py::str>(key)) {
      throw ArgumentError(place + ": found the key " + py::repr(key).cast<std::string>() + ", expected a string");
    }
    const auto name = text_json(key, place).get<std::string>();
    std::string below = place;
    if (!below.empty()) below += '/';
    json[name] = json_of(value, below += name);
  }
  return json;
}

}  // namespace

Json json_of(py::handle object, const std::string& place) {
  const Depth depth;
  if (object.is_none()) return nullptr;
  if (py::isinstance<py::bool_>(object)) return object.cast<bool>();
  if (py::isinstance<py::float_>(object)) return number_json(object, place);
  if (py::isinstance<py::int_>(object)) return integer_json(object, place);
  if (py::isinstance<py::str>(object)) return text_json(object, place);
  if (py::isinstance<py::dict>(object)) return dict_json(py::reinterpret_borrow<py::dict>(object), place);
  if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object)) return list_json(object, place);
  // Arrays and numbers of numpy's, and whatever else knows how to become lists.
  if (py::hasattr(object, "tolist")) return json_of(object.attr("tolist")(), place);
  throw ArgumentError(place + ": found " + py::repr(py::type::of(object)).cast<std::string>() +
                      ", expected numbers, strings, lists, arrays or dictionaries");
}

py::object object_of(const Json& json) {
  return py::module_::import("json").attr("loads")(json.dump());
}

}  // namespace gnomon::python
