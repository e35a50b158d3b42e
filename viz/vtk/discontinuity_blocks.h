#pragma once

#include <vector>

#include "viz/vtk/block.h"
#include "viz/vtk/discontinuity_result.h"

namespace gnomon::viz {

/// The blocks of a result, with those of the scene's elements. Faces are cut into triangles, which bear their face's
/// number as `facet_id`; edges are lines, with the point array `visible_fraction` on both where it is known, and the
/// cell arrays `event` (text numbers into the field array `event_names`), `discontinuity_order`, `edge_index` and
/// `vertex_index`.
std::vector<Block> discontinuity_blocks(const DiscontinuityResult& result);

}  // namespace gnomon::viz
