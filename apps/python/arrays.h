#pragma once

/// Arrays of Python's: rows of numbers as they lie in memory, and new ones for results.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "gnomon/point.h"

namespace gnomon::python {

namespace py = pybind11;

/// An argument makes no sense; what() names it, and says what was found and what was expected.
class ArgumentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Rows of finite numbers. An array of doubles is read where it lies, whatever its strides; of others a copy is made,
/// in doubles that are equal.
class Rows {
 public:
  /// Throws: ArgumentError for what is no array of numbers of shape (n, columns), or has one that is not finite.
  Rows(py::handle array, const char* name, std::size_t columns);

  std::size_t count() const { return count_; }
  double at(std::size_t row, std::size_t column) const {
    double value = 0;
    std::memcpy(&value, data_ + static_cast<py::ssize_t>(row) * row_step_ + static_cast<py::ssize_t>(column) * step_,
                sizeof value);
    return value;
  }
  Point3 point(std::size_t row) const { return {at(row, 0), at(row, 1), at(row, 2)}; }
  Point2 planar_point(std::size_t row) const { return {at(row, 0), at(row, 1)}; }
  const py::array& array() const { return array_; }

  /// Throws: ArgumentError unless this is as long as the other.
  void require_count(const Rows& other) const;
  /// Throws: ArgumentError naming the first row that is zero.
  void require_directions() const;

 private:
  std::string name_;
  py::array array_;
  const char* data_ = nullptr;
  py::ssize_t row_step_ = 0, step_ = 0;
  std::size_t count_ = 0, columns_ = 0;
};

/// A new array of that shape.
template <class Number>
py::array_t<Number> new_array(std::size_t rows, std::size_t columns) {
  return py::array_t<Number>({static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(columns)});
}

/// Points as an array of shape (n, 3).
py::array_t<double> points_array(std::span<const Point3> points);

/// Lists of that many indices as an array of shape (n, N).
template <std::size_t N>
py::array_t<std::uint32_t> index_array(std::span<const std::array<std::uint32_t, N>> lists) {
  auto result = new_array<std::uint32_t>(lists.size(), N);
  if (!lists.empty()) std::memcpy(result.mutable_data(), lists.data(), lists.size_bytes());
  return result;
}

/// A rational number as fractions.Fraction.
py::object fraction(const std::string& exact);

/// Gives a class of results the method to_vtk.
template <class Class>
void bind_to_vtk(Class& result) {
  result.def(
      "to_vtk", [](const py::object& self) { return py::module_::import("gnomon.vtk_data").attr("to_vtk")(self); },
      "The result as a data set of VTK, which pyvista wraps: see gnomon.to_vtk.");
}

/// "a, b" of a tuple of names, in quotes.
std::string listed_names(const std::vector<std::string>& names);

}  // namespace gnomon::python
