#pragma once

#include <string>

#include <rapidcheck.h>

#include "apps/proof/laws/census.h"
#include "apps/proof/laws/example.h"
#include "apps/proof/laws/law.h"
#include "gnomon/light.h"

namespace gnomon::laws {

/// A light and a flat blocker in standard position, and two points.
struct SpatialCase {
  Light light;
  ConvexPolygon blocker;
  Point3 point;
  Point3 other;
};

/// The case as text from which it can be built again: 17 digits, every vertex.
std::string description(const SpatialCase& drawn);

/// The case as a scene.
Example example(const SpatialCase& drawn);

/// Adds the regions of the pair and that of the point to the counts.
void count_regions(const SpatialCase& drawn, Census& census);

/// Which lights take part.
enum class Lights { points, with_extent, all };

/// Where points lie.
enum class View { any, before_light };

/// Pairs in standard position, made so and not searched for: area lights (one- and two-sided, with 3 to 7 vertices,
/// collinear ones among them), linear lights (their lines missing the blocker, hitting it, passing through an edge or
/// a corner, parallel to it or coplanar with an edge) and point lights, before flat blockers of either winding. Points
/// lie anywhere, on extremal planes, on and beside the volumes, on the blocker, in the light's plane, behind the light.
/// Half of those before the light lie between the two, where they are often beyond planes of light edges.
rc::Gen<SpatialCase> spatial_cases(Domain domain, Lights lights, View view = View::any);

}  // namespace gnomon::laws
