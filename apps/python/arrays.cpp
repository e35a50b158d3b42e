#include "apps/python/arrays.h"

#include <cmath>

namespace gnomon::python {
namespace {

/// Integers up to here are doubles.
constexpr double largest_integer = 9007199254740992;

std::string shape_text(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t k = 0; k < array.ndim(); ++k) text += (k > 0 ? ", " : "") + std::to_string(array.shape(k));
  return text + (array.ndim() == 1 ? ",)" : ")");
}

[[noreturn]] void refuse(const std::string& name, const std::string& found, const std::string& expected) {
  throw ArgumentError(name + ": found " + found + ", expected " + expected);
}

bool is_readable(const py::array& array) {
  const auto aligned = py::detail::npy_api::NPY_ARRAY_ALIGNED_;
  return py::isinstance<py::array_t<double>>(array) && (array.flags() & aligned) != 0;
}

/// The same numbers in doubles.
py::array converted(const py::array& array, const std::string& name) {
  const char kind = array.dtype().kind();
  const bool is_empty = array.size() == 0;
  if (!is_empty && kind != 'f' && kind != 'i' && kind != 'u') {
    refuse(name, "an array of " + std::string(py::str(array.dtype())), "real numbers");
  }
  if (kind == 'f' && array.itemsize() > 8) {
    refuse(name, "an array of " + std::string(py::str(array.dtype())), "numbers that doubles hold");
  }
  py::array doubles = py::array_t<double, py::array::c_style | py::array::forcecast>(array);
  if (kind == 'f' || array.itemsize() < 8) return doubles;
  const auto* numbers = static_cast<const double*>(doubles.data());
  for (py::ssize_t i = 0; i < doubles.size(); ++i) {
    if (std::abs(numbers[i]) >= largest_integer) refuse(name, "integers of 2^53 or more", "numbers that doubles hold");
  }
  return doubles;
}

/// Of an array's own class there are no masks.
void refuse_masks(const py::array& array, const std::string& name) {
  static const PyTypeObject* plain = Py_TYPE(py::array_t<double>(py::ssize_t{0}).ptr());
  if (Py_TYPE(array.ptr()) == plain || !py::hasattr(array, "mask")) return;
  const bool is_masked = py::module_::import("numpy").attr("any")(array.attr("mask")).cast<bool>();
  if (is_masked) refuse(name, "an array with masked numbers", "numbers that are all there");
}

/// What numpy makes of it, of whatever numbers.
py::array as_array(py::handle object, const std::string& name) {
  if (py::isinstance<py::array>(object)) {
    auto array = py::reinterpret_borrow<py::array>(object);
    refuse_masks(array, name);
    return array;
  }
  try {
    return py::module_::import("numpy").attr("asarray")(object);
  } catch (py::error_already_set&) {
    refuse(name, "what is no array", "an array of numbers");
  }
}

}  // namespace

Rows::Rows(py::handle array, const char* name, std::size_t columns)
    : name_(name), array_(as_array(array, name_)), columns_(columns) {
  if (!is_readable(array_)) array_ = converted(array_, name_);
  const bool is_empty_list = array_.ndim() == 1 && array_.shape(0) == 0;
  if (is_empty_list) return;
  if (array_.ndim() != 2 || array_.shape(1) != static_cast<py::ssize_t>(columns)) {
    const bool is_one = array_.ndim() == 1 && array_.shape(0) == static_cast<py::ssize_t>(columns);
    refuse(name_, "an array of shape " + shape_text(array_),
           "shape (n, " + std::to_string(columns) + ")" + (is_one ? "; one row alone is [[...]]" : ""));
  }
  data_ = static_cast<const char*>(array_.data());
  row_step_ = array_.strides(0);
  step_ = array_.strides(1);
  count_ = static_cast<std::size_t>(array_.shape(0));
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t k = 0; k < columns; ++k) {
      if (!std::isfinite(at(i, k))) {
        refuse(name_, py::str(py::float_(at(i, k))).cast<std::string>() + " in row " + std::to_string(i),
               "finite numbers");
      }
    }
  }
}

void Rows::require_count(const Rows& other) const {
  if (count_ == other.count_) return;
  refuse(name_, std::to_string(count_) + (count_ == 1 ? " row" : " rows"),
         std::to_string(other.count_) + ", as many as " + other.name_);
}

void Rows::require_directions() const {
  for (std::size_t i = 0; i < count_; ++i) {
    bool is_zero = true;
    for (std::size_t k = 0; k < columns_; ++k) is_zero = is_zero && at(i, k) == 0;
    if (is_zero) refuse(name_, "zeros in row " + std::to_string(i), "a direction");
  }
}

py::array_t<double> points_array(std::span<const Point3> points) {
  auto result = new_array<double>(points.size(), 3);
  if (!points.empty()) std::memcpy(result.mutable_data(), points.data(), points.size_bytes());
  return result;
}

py::object fraction(const std::string& exact) {
  return py::module_::import("fractions").attr("Fraction")(exact);
}

std::string listed_names(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text.empty() ? "none" : text;
}

}  // namespace gnomon::python
