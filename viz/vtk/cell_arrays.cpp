#include "viz/vtk/cell_arrays.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "gnomon/errors.h"

namespace gnomon::viz {
namespace {

constexpr CellArray arrays[] = {
    {"region", "uint8", "255",
     "0 lit, 1 penumbra, 2 umbra, 3 unlit, 4 unresolved_eee; 255 for the occlusion, which is penumbra and umbra "
     "together"},
    {"light_id", "int32", "-1", "position in the scene's list of lights"},
    {"blocker_id", "int32", "-1", "position in the scene's list of blockers"},
    {"facet_id", "int32", "-1",
     "triangles of one flat facet of the block's surface share the number; in the plane every cell has its own"},
    {"facet_kind", "uint8", "255",
     "0 blocker face, 1 separating blocker plane, 2 separating light plane, 3 supporting blocker plane, 4 clip box, "
     "5 light plane"},
    {"edge_index", "int32", "-1",
     "edge i runs from vertex i to i + 1 as in the scene file: a blocker edge for kinds 1 and 3, a light edge for 2, "
     "the side (x min, x max, y min, y max, z min, z max) for 4; in the plane the blocker's end for 1 and 3"},
    {"vertex_index", "int32", "-1",
     "the vertex that the plane touches: of the light for kinds 1 and 3, of the blocker for 2; in the plane the "
     "light's "
     "end for 1 and 3"},
    {"discontinuity_order", "int32", "-1", "order of the discontinuity of the visible fraction across the cell"},
    {"visible_fraction", "float64", "nan",
     "visible part of the light inside the cell or behind the surface, where it is one number"},
};

/// Not a number stands for none and is not even equal to itself.
template <class Value>
bool is_none(Value value, Value none) {
  return value == none || value != value;
}

template <class Array, class Value>
void add_array(vtkDataSet& data, const char* name, std::span<const CellName> names, Value CellName::*member) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i) array->SetValue(static_cast<vtkIdType>(i), names[i].*member);
  data.GetCellData()->AddArray(array);
}

/// Adds the arrays of which `is_wanted(name, says_nothing)` is true.
template <class Wanted>
void add_arrays(vtkDataSet& data, std::span<const CellName> names, const Wanted& is_wanted) {
  const auto add = [&]<class Array, class Value>(Array*, const char* name, Value CellName::*member) {
    const auto is_silent = [&](const CellName& cell) { return is_none(cell.*member, CellName{}.*member); };
    if (is_wanted(name, std::ranges::all_of(names, is_silent))) add_array<Array>(data, name, names, member);
  };
  constexpr vtkUnsignedCharArray* bytes = nullptr;
  constexpr vtkIntArray* integers = nullptr;
  add(bytes, "region", &CellName::region);
  add(integers, "light_id", &CellName::light_id);
  add(integers, "blocker_id", &CellName::blocker_id);
  add(integers, "facet_id", &CellName::facet_id);
  add(bytes, "facet_kind", &CellName::facet_kind);
  add(integers, "edge_index", &CellName::edge_index);
  add(integers, "vertex_index", &CellName::vertex_index);
  add(integers, "discontinuity_order", &CellName::discontinuity_order);
  add(static_cast<vtkDoubleArray*>(nullptr), "visible_fraction", &CellName::visible_fraction);
}

}  // namespace

std::span<const CellArray> cell_arrays() {
  return arrays;
}

void add_cell_arrays(vtkDataSet& data, std::span<const CellName> names) {
  if (data.GetNumberOfCells() != static_cast<vtkIdType>(names.size())) {
    throw PreconditionError("cell arrays: one name per cell");
  }
  add_arrays(data, names, [](const char*, bool says_nothing) { return !says_nothing; });
}

std::vector<std::string> names_of_cell_arrays(vtkDataSet& data) {
  std::vector<std::string> names;
  for (int i = 0; i < data.GetCellData()->GetNumberOfArrays(); ++i) {
    names.emplace_back(data.GetCellData()->GetArrayName(i));
  }
  return names;
}

void add_empty_cell_arrays(vtkDataSet& data, std::span<const std::string> names) {
  const std::vector<CellName> none(static_cast<std::size_t>(data.GetNumberOfCells()));
  add_arrays(data, none, [&](const char* name, bool) {
    return std::ranges::count(names, name) > 0 && !data.GetCellData()->HasArray(name);
  });
}

}  // namespace gnomon::viz
