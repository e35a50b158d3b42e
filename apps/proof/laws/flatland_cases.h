#pragma once

#include <array>
#include <string>
#include <vector>

#include <rapidcheck.h>

#include "apps/proof/laws/census.h"
#include "apps/proof/laws/example.h"
#include "apps/proof/laws/law.h"
#include "gnomon/flatland.h"

namespace gnomon::laws {

/// A light among blockers in the plane, and a point.
struct FlatlandCase {
  std::vector<Point2> light;
  std::vector<planar::BlockerSegment> blockers;
  Point2 point;

  planar::Flatland flatland() const { return planar::Flatland::from_points(light, blockers); }
};

/// The case as text from which it can be built again: 17 digits.
std::string description(const FlatlandCase& drawn);

/// The case as a scene.
Example example(const FlatlandCase& drawn);

/// Adds the umbrae and penumbrae behind all blockers and the region of the point to the counts.
void count_regions(const FlatlandCase& drawn, Census& census);

/// What the blockers make up.
enum class Layout {
  scattered,  ///< segments between points of a coarse grid: they touch, cross, overlap and repeat
  chain,      ///< a polyline
  spiral,     ///< a polyline that winds around the light or beside it
  comb,       ///< parallel teeth, on a back or without it
  grid,       ///< segments of the lines of a grid
  on_light,   ///< segments that cross the light, lie on its line or end on it, and others
  any,        ///< one of these
  joint,      ///< first two that share an end and leave it to different sides, then scattered ones
};

/// Lights among one to `most` blockers, and a tooth or so more. Points lie anywhere, on blockers, on the light's line,
/// and on lines through two ends.
rc::Gen<FlatlandCase> flatland_cases(Domain domain, Layout layout, int most = 6);

}  // namespace gnomon::laws
