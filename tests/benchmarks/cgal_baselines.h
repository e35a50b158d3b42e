#pragma once

#include <cstddef>

#include "apps/proof/report/polygon_pairs.h"

namespace gnomon::benchmarks {

/// Facets of the occlusion volume above z = -4, from the half-spaces of the given extremal planes.
/// CGAL's halfspace_intersection_3, EPICK.
std::size_t facets_of_halfspace_intersection(const report::PolygonPair& pair);

}  // namespace gnomon::benchmarks
