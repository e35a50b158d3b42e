#pragma once

/// Meshes as models have them, irregular in size and shape, above a floor and under a lamp as wide as they are.

#include <cstddef>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/convex_polygon.h"
#include "gnomon/light.h"

namespace gnomon::benchmarks {

using Triangles = std::vector<ConvexBlocker>;

/// A closed ball around (0, 0, 2) of `rings` times `around` facets, 2 around (rings - 1) triangles, in radii drawn
/// between `least` and 1: spiky where these differ much, a sphere where they do not. Angles are drawn a little off a
/// grid's unless all radii are 1.
Triangles ball(std::size_t rings, std::size_t around, double least);

/// An open sheet over a square of side 4, of 2 n^2 triangles of drawn corners and heights.
Triangles rough_sheet(std::size_t n);

/// Tufts of sixteen thin leaves, each of one triangle from a common foot, as plants in models are.
Triangles tufts(std::size_t count);

/// As wide as the models, above them.
Light wide_lamp();

/// A square of side 12 below them.
ConvexPolygon floor_below();

}  // namespace gnomon::benchmarks
