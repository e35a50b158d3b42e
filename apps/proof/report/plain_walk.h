#pragma once

#include "gnomon/pair.h"

namespace gnomon::report {

/// What extremal_planes(light, blocker) would be if doubles were real numbers: the same walk, the same result, the same
/// allocations; signs of rounded determinants, and no word about the position of the pair.
///
/// Requires: standard position; no polygon has collinear vertices; no ties that rounding could break.
ExtremalPlanes plain_extremal_planes(const AreaLight& light, const ConvexPolygon& blocker);

}  // namespace gnomon::report
