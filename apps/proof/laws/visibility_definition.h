#pragma once

/// What a point sees behind any number of convex blockers, decided as the definition is written: does the open segment
/// between the two meet a blocker?

#include <vector>

#include "apps/proof/laws/exact.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"
#include "gnomon/names.h"

namespace gnomon::laws {

/// A convex set: the points below all of its planes, or on them. A flat polygon has its plane twice.
using Walls = std::vector<ExactPlane>;

/// The walls of a blocker; those of a solid are found by trying every three of its points.
Walls walls(const ConvexBlocker& blocker);

/// True if the open segment (p, l) meets the set, found by clipping the segment.
bool is_blocked(const Walls& blocker, const ExactVector& p, const ExactVector& l);

/// The same for the open ray from p in a direction.
bool is_blocked_towards(const Walls& blocker, const ExactVector& p, const ExactVector& direction);

/// The visible share of a segment: its points change between visible and hidden only where a pair of walls does,
/// and one point is asked between every two such places.
Rational visible_length_share(const ExactVector& start, const ExactVector& end, const std::vector<Walls>& blockers,
                              const ExactVector& p);

/// The visible share of a flat convex polygon, by inclusion and exclusion of what the blockers hide together.
///
/// Cost: exponential in the number of blockers.
Rational visible_area_share(const std::vector<ExactVector>& polygon, const std::vector<Walls>& blockers,
                            const ExactVector& p);

/// The flat pieces of an area light: itself, or the triangles of the fan from its first vertex that have an area.
std::vector<std::vector<ExactVector>> light_facets(const ConvexPolygon& polygon);

/// The region of p behind all blockers together.
Region region_behind(const std::vector<Walls>& blockers, const Light& light, const ExactVector& p);

/// True if the light shows p its back or its edge, with all of its pieces.
bool is_unlit(const Light& light, const ExactVector& p);

}  // namespace gnomon::laws
