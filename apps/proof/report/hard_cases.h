#pragma once

#include <string>
#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::report {

/// A scene in which rounding is likely to decide wrongly, and a point of it that matters.
struct HardCase {
  std::string name;
  std::string about;  ///< what is hard, in a few words
  AreaLight light;
  std::vector<ConvexBlocker> blockers;
  Point3 focus;
  Point3 normal{0, 0, 1};
};

/// The corpus: events met exactly and one ulp off, far and small and needle-like things, contact and penetration,
/// coincident blockers, many corners, faces rounded off their planes, and coordinates at the ends of doubles.
std::vector<HardCase> hard_cases();

/// Points where it is hard to say what they see: the focus, and points on planes through an edge and a vertex and on
/// lines through two vertices, as doubles hold them; and beside these by a few ulps, or by up to a tenth of the way.
///
/// Returns: `count` finite points; the first is the focus. Always the same for a name.
std::vector<Point3> points_around(const HardCase& hard, std::size_t count);

}  // namespace gnomon::report
