#pragma once

#include <span>
#include <string>
#include <vector>

#include "viz/vtk/field_data.h"

namespace gnomon::viz {

/// A block file in the tree.
struct TreeLeaf {
  std::vector<std::string> path;
  std::string file;  ///< relative to the tree's file
};

/// The text of a `.vtm` file: the leaves as nested blocks that keep their names, and the fields on the root.
std::string multiblock_xml(std::span<const TreeLeaf> leaves, const Fields& fields);

/// The text of a `.vtpc` file: one partitioned data set per leaf, named by its whole path, an assembly that repeats the
/// tree, and the fields on the root. Assembly nodes may not have every name; their `label` is the name.
std::string partitioned_xml(std::span<const TreeLeaf> leaves, const Fields& fields);

}  // namespace gnomon::viz
