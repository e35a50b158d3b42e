#pragma once

#include <string>
#include <vector>

#include "apps/proof/laws/census.h"
#include "apps/proof/laws/example.h"
#include "apps/proof/laws/law.h"
#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::laws {

enum class PairLightKind { point, direction, segment, one_sided_polygon, two_sided_polygon, rounded_polygon };
enum class PairBlockerKind { flat_polygon, solid, rounded_polygon };

/// What a pair is made of.
struct PairKinds {
  PairLightKind light;
  PairBlockerKind blocker;
  const char* name;
};

/// Every kind of light with every kind of blocker.
inline constexpr PairKinds all_pair_kinds[] = {
    {PairLightKind::point, PairBlockerKind::flat_polygon, "PointFlat"},
    {PairLightKind::point, PairBlockerKind::solid, "PointSolid"},
    {PairLightKind::point, PairBlockerKind::rounded_polygon, "PointRounded"},
    {PairLightKind::direction, PairBlockerKind::flat_polygon, "DirectionFlat"},
    {PairLightKind::direction, PairBlockerKind::solid, "DirectionSolid"},
    {PairLightKind::direction, PairBlockerKind::rounded_polygon, "DirectionRounded"},
    {PairLightKind::segment, PairBlockerKind::flat_polygon, "SegmentFlat"},
    {PairLightKind::segment, PairBlockerKind::solid, "SegmentSolid"},
    {PairLightKind::segment, PairBlockerKind::rounded_polygon, "SegmentRounded"},
    {PairLightKind::one_sided_polygon, PairBlockerKind::flat_polygon, "PolygonFlat"},
    {PairLightKind::one_sided_polygon, PairBlockerKind::solid, "PolygonSolid"},
    {PairLightKind::one_sided_polygon, PairBlockerKind::rounded_polygon, "PolygonRounded"},
    {PairLightKind::two_sided_polygon, PairBlockerKind::flat_polygon, "TwoSidedFlat"},
    {PairLightKind::two_sided_polygon, PairBlockerKind::solid, "TwoSidedSolid"},
    {PairLightKind::two_sided_polygon, PairBlockerKind::rounded_polygon, "TwoSidedRounded"},
    {PairLightKind::rounded_polygon, PairBlockerKind::flat_polygon, "RoundedFlat"},
    {PairLightKind::rounded_polygon, PairBlockerKind::solid, "RoundedSolid"},
    {PairLightKind::rounded_polygon, PairBlockerKind::rounded_polygon, "RoundedRounded"},
};

/// A light and a blocker wherever they stand, and points.
struct AnyPair {
  Light light;
  ConvexBlocker blocker;
  std::vector<Point3> points;
};

/// The pair as text from which it can be built again: 17 digits, every vertex.
std::string description(const AnyPair& pair);

/// The case as a scene.
Example example(const AnyPair& drawn);

/// Adds the regions of the pair and that of the first point to the counts.
void count_regions(const AnyPair& drawn, Census& census);

/// Draws a pair with small integer coordinates, so that the two touch, cross, share elements and lie in common planes
/// in a good part of the cases; bent toward degeneracy by ulps, offsets and scales in the near-degenerate domain.
/// Points lie anywhere, on lines through both and their ends, on planes through edges, on the blocker.
///
/// Requires: called inside rc::gen::exec.
AnyPair draw_any_pair(Domain domain, PairLightKind light, PairBlockerKind blocker, int points);

}  // namespace gnomon::laws
