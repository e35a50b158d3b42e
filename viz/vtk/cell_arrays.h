#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

class vtkDataSet;

namespace gnomon::viz {

/// What the cell arrays say of one cell. The defaults stand for "none" or "not known".
struct CellName {
  std::uint8_t region = 255;
  std::int32_t light_id = -1;
  std::int32_t blocker_id = -1;
  std::int32_t facet_id = -1;
  std::uint8_t facet_kind = 255;
  std::int32_t edge_index = -1;
  std::int32_t vertex_index = -1;
  std::int32_t discontinuity_order = -1;
  double visible_fraction = std::numeric_limits<double>::quiet_NaN();
};

/// A cell array as the manifest describes it.
struct CellArray {
  std::string_view name;
  std::string_view type;
  std::string_view none;  ///< the value that stands for none
  std::string_view meaning;
};

/// The arrays that a block may have, in order; it has those that say something of one of its cells.
std::span<const CellArray> cell_arrays();

/// Adds the arrays that hold more than "none", one name per cell in the order of the cells.
///
/// Requires: as many names as cells.
void add_cell_arrays(vtkDataSet& data, std::span<const CellName> names);

/// The names of the arrays that the data have, in order.
std::vector<std::string> names_of_cell_arrays(vtkDataSet& data);

/// Adds those of the named arrays that the data lack, "none" in every cell.
void add_empty_cell_arrays(vtkDataSet& data, std::span<const std::string> names);

}  // namespace gnomon::viz
