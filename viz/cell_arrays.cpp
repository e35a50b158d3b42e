#include "viz/cell_arrays.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include "geometry/errors.h"

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

template <class Array, class Value>
void add_array(vtkDataSet& data, const char* name, std::span<const CellName> names, Value CellName::*member) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i) array->SetValue(static_cast<vtkIdType>(i), names[i].*member);
  data.GetCellData()->AddArray(array);
}

}  // namespace

std::span<const CellArray> cell_arrays() {
  return arrays;
}

void add_cell_arrays(vtkDataSet& data, std::span<const CellName> names) {
  if (data.GetNumberOfCells() != static_cast<vtkIdType>(names.size())) {
    throw PreconditionError("cell arrays: one name per cell");
  }
  add_array<vtkUnsignedCharArray>(data, "region", names, &CellName::region);
  add_array<vtkIntArray>(data, "light_id", names, &CellName::light_id);
  add_array<vtkIntArray>(data, "blocker_id", names, &CellName::blocker_id);
  add_array<vtkIntArray>(data, "facet_id", names, &CellName::facet_id);
  add_array<vtkUnsignedCharArray>(data, "facet_kind", names, &CellName::facet_kind);
  add_array<vtkIntArray>(data, "edge_index", names, &CellName::edge_index);
  add_array<vtkIntArray>(data, "vertex_index", names, &CellName::vertex_index);
  add_array<vtkIntArray>(data, "discontinuity_order", names, &CellName::discontinuity_order);
  add_array<vtkDoubleArray>(data, "visible_fraction", names, &CellName::visible_fraction);
}

}  // namespace gnomon::viz
