#pragma once

#include <array>
#include <string>
#include <vector>

#include <rapidcheck.h>

#include "apps/proof/laws/census.h"
#include "apps/proof/laws/example.h"
#include "apps/proof/laws/law.h"
#include "gnomon/flatland_pair.h"

namespace gnomon::laws {

/// A light and a blocker of the plane, and two points.
struct PlanarCase {
  std::vector<Point2> light;
  std::array<Point2, 2> blocker;
  Point2 point;
  Point2 other;

  planar::Pair pair() const { return planar::Pair::from_points(light, blocker); }
};

/// The case as text from which it can be built again: 17 digits.
std::string description(const PlanarCase& drawn);

/// The case as a scene.
Example example(const PlanarCase& drawn);

/// Adds the regions of the pair and that of the point to the counts.
void count_regions(const PlanarCase& drawn, Census& census);

/// How the two are meant to stand to each other; bending toward degeneracy may change it.
enum class Stand {
  apart,              ///< the light on one side of the blocker's line
  light_line_hits,    ///< so, and the light's line meets the blocker
  blocker_line_hits,  ///< the blocker's line meets the light, inside or at an end
  on_one_line,        ///< light and blocker
  any,                ///< one of these
};

/// Point and linear lights and segments. Points lie anywhere, on and beside the lines through ends of both, on the
/// blocker, on its line, on the light.
rc::Gen<PlanarCase> planar_cases(Domain domain, Stand stand);

}  // namespace gnomon::laws
