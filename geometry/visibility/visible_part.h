#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/region.h"
#include "geometry/spatial/light.h"
#include "geometry/visibility/exact_vector.h"
#include "geometry/visibility/hidden_set.h"

namespace gnomon {

/// A flat piece of an area light, and what is seen of it.
struct SeenFacet {
  ExactPolygon facet;                 ///< counterclockwise seen from its front
  std::vector<ExactPolygon> visible;  ///< convex, each with an area, not overlapping; wound like the facet
};

/// What a point sees of a light.
struct VisiblePart {
  /// A part of a segment, as shares of the way from its start to its end.
  using Interval = std::array<Rational, 2>;

  Region region = Region::lit;
  std::vector<SeenFacet> facets;    ///< of an area light: one, or the triangles of a rounded polygon; none if unlit
  std::vector<Interval> intervals;  ///< of a linear light: disjoint, each with a length, ascending
};

/// The light without what is hidden from p, up to what has no area (length).
///
/// Definition:   l is hidden if the open segment (p, l), for a direction the open ray, meets a blocker.
/// `hidden` are the conditions of each blocker, made for the same p.
/// Degenerate:   a point in the plane of an area light, or behind a one-sided one, is unlit; of a rounded polygon:
///               behind or in the plane of every triangle of the fan from its first vertex. A point light at p itself
///               is hidden only inside a solid, where `hidden` has an empty list.
/// Exactness:    rational throughout.
VisiblePart visible_part(const Light& light, std::span<const std::vector<HidingCondition>> hidden,
                         const ExactVector& p);

/// The triangles of the fan from the first vertex that have an area, or the polygon's corners where it is flat.
std::vector<ExactPolygon> flat_facets(const ConvexPolygon& polygon);

}  // namespace gnomon
