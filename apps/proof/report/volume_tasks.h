#pragma once

#include <vector>

#include "apps/proof/report/visibility_tasks.h"

namespace gnomon::report {

/// Occlusion and umbra of a light and a blocker of n vertices each, down to a floor: one task per n.
///
/// Measurements of the tasks "occlusion_volume" and "umbra_volume" by the methods gnomon (both meshes, rounded
/// vertices), exact (both, with exact volumes), convex_hull_3 (the occlusion) and nef_3 (the umbra, for small n).
/// Errors are relative to the exact volume.
std::vector<Task> volume_tasks(Effort effort);

}  // namespace gnomon::report
