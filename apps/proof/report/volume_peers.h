#pragma once

#include <cstddef>

#include "apps/proof/report/polygon_pairs.h"

namespace gnomon::report {

/// The occlusion volume above z = -4 as the hull of all vertex shadows, cut off: the blocker's vertices b, and
/// b + t (b - l) for every light vertex l, with t such that the far points lie in the plane z = -4. CGAL's
/// convex_hull_3, inexact constructions.
///
/// Requires: every light vertex lies above z = 3, every blocker vertex between z = 1 and z = 3.
///
/// Returns: the number of facets.
std::size_t facets_of_vertex_shadow_hull(const PolygonPair& pair);

/// Its volume, added up exactly: the facets come in an order that differs from run to run.
double volume_of_vertex_shadow_hull(const PolygonPair& pair);

/// The umbra above z = -4 as the intersection of the shadows of the light's vertices. CGAL's Nef_polyhedron_3, exact
/// constructions.
///
/// Requires: as above.
///
/// Returns: its volume.
double volume_of_nef_umbra(const PolygonPair& pair);

}  // namespace gnomon::report
