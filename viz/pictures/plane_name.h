#pragma once

#include <string>

#include "viz/pictures/picture_source.h"

namespace gnomon::viz {

/// The name of the plane that a cell of a volume's surface lies on, by the input elements that make it:
/// "supporting plane: edge 2 of table, vertex 0 of lamp"; empty where the cell arrays do not tell.
std::string plane_name(const PictureBlock& volume, vtkIdType cell);

}  // namespace gnomon::viz
