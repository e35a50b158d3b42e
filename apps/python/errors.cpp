#include "gnomon/errors.h"
#include "apps/gnomon/commands.h"
#include "apps/python/arrays.h"
#include "apps/python/bindings.h"

namespace gnomon::python {
namespace {

/// The exception of that name, which gnomon/errors.py defines, with a sentence.
void set_error(const char* name, const char* sentence) {
  const py::object type = py::module_::import("gnomon.errors").attr(name);
  PyErr_SetString(type.ptr(), sentence);
}

/// The program's sentences begin with an option; arguments have its name without the dashes.
std::string of_argument(const std::string& sentence) {
  return sentence.starts_with("--") ? sentence.substr(2) : sentence;
}

void translate(std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param): as pybind11 calls it
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const UnsupportedSceneError& error) {
    set_error("UnsupportedError", error.what());
  } catch (const SceneError& error) {
    set_error("SceneError", error.what());
  } catch (const UnsupportedError& error) {
    set_error("UnsupportedError", error.what());
  } catch (const ArgumentError& error) {
    set_error("ArgumentError", error.what());
  } catch (const UsageError& error) {
    set_error("ArgumentError", of_argument(error.what()).c_str());
  } catch (const PreconditionError& error) {
    set_error("ArgumentError", error.what());
  }
}

}  // namespace

void warn(const std::string& sentence) {
  const py::object category = py::module_::import("gnomon.errors").attr("SceneWarning");
  if (PyErr_WarnEx(category.ptr(), sentence.c_str(), 1) != 0) throw py::error_already_set();
}

void bind_errors(py::module_&) {
  py::register_exception_translator(translate);
}

}  // namespace gnomon::python
