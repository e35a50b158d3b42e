#pragma once

#include <cstddef>
#include <vector>

#include "apps/gnomon/point_batches.h"
#include "shading/receiver_grid.h"

namespace gnomon {

/// The next rows of a table x,y,z,nx,ny,nz of the grid's points that lie on the receiver, at most 1,024. `next` is the
/// index of the point to begin with, and is moved on. None at the end.
std::vector<TableRow> next_rows(const ReceiverGrid& grid, std::size_t& next);

}  // namespace gnomon
