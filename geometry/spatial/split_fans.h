#pragma once

#include "geometry/spatial/exact_surface.h"

namespace gnomon {

/// Splits vertices at which a closed surface touches itself, so that every edge belongs to exactly two triangles.
///
/// Definition: occlusion and umbra may have an edge of one in a facet or edge of the other (on a side of the clip box);
///             there four triangles meet. Each of the sheets that only touch gets vertices of its own at the same
///             place; an edge that then still has two sheets is divided, in each at a vertex of its own in the middle.
/// Requires:   the facets from `first_inner` on are those of the umbra, turned inward; every edge is in two triangles,
///             or in four, of which one in each direction is inward.
void split_fans(ExactSpace& space, ExactSurface& surface, std::size_t first_inner);

}  // namespace gnomon
