#pragma once

#include <cstdint>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::report {

/// A solid of that many triangles, nearly a sphere of radius 1.3, in which nothing is aligned.
/// Requires: an even number, at least 4.
ConvexSolid sphere(std::uint32_t facets);

/// Its facets, each a blocker of its own.
std::vector<ConvexBlocker> sphere_facets(std::uint32_t facets);

/// A square light above it.
Light lamp_above_sphere();

}  // namespace gnomon::report
