#pragma once

#include <span>

#include "shading/image/surfaces.h"

namespace gnomon::image {

/// Gives the facets of one element normals at their corners: means of the normals of all facets with a corner at the
/// same place whose normals differ from the facet's own by at most the crease, weighted as asked for.
///
/// Degenerate: where the mean is zero the facet stays flat.
/// Exactness:  in doubles; a normal is what it is rounded to.
/// Returns:    how many facets stayed flat for that reason.
std::size_t add_vertex_normals(std::span<Facet> facets, const Smoothness& smoothness);

}  // namespace gnomon::image
