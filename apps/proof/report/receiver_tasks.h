#pragma once

#include <vector>

#include "apps/proof/report/visibility_tasks.h"

namespace gnomon::report {

/// Areas of lit, penumbra and umbra on a floor below a square light and n boards: one task per n.
///
/// Measurements of the task "receiver_areas" by the methods exact_mesh (the receiver's mesh), gnomon_raster (the region
/// of points in a raster) and embree_raster (16 shadow rays from each). Errors are shares of the floor's area, three
/// results each.
std::vector<Task> receiver_tasks(Effort effort);

}  // namespace gnomon::report
