#pragma once

#include <array>
#include <string>

#include <rapidcheck.h>

#include "apps/proof/laws/visibility_cases.h"

namespace gnomon::laws {

/// An area light and a flat blocker that share a vertex or an edge, and a point near what they share, in their shadow
/// or beside it.
rc::Gen<VisibilityCase> pairs_that_share(Domain domain);

/// An area light before a board that is cut into two rectangles, and a point behind it.
rc::Gen<VisibilityCase> cut_boards(Domain domain);

/// An area light above a solid, and two points with a plane between them.
struct PocketCase {
  VisibilityCase visibility;  ///< its point is one of the two
  Point3 other;
  std::array<Point3, 3> plane;
};

std::string description(const PocketCase& drawn);
Example example(const PocketCase& drawn);
void count_regions(const PocketCase& drawn, Census& census);

/// A lamp, long and narrow, above a pyramid on its tip.
struct PyramidMeasures {
  double lamp_length = 4;
  double lamp_width = 0.25;
  double height = 1;   ///< of the lamp
  double depth = 1;    ///< of the tip
  double aside = 0.9;  ///< the points, at both sides of the plane
  double below = 0.25;
};

PocketCase pyramid_case(const PyramidMeasures& measures);

/// Lamps above pyramids, moved and sheared.
rc::Gen<PocketCase> pyramid_cases(Domain domain);

}  // namespace gnomon::laws
