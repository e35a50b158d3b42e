#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "geometry/numbers/exact_vector.h"
#include "geometry/visibility/hidden_set.h"
#include "gnomon/visibility.h"

namespace gnomon {

/// A flat piece of an area light, and what is seen of it.
struct VisibleFacet {
  ExactPolygon facet;                 ///< counterclockwise seen from its front
  std::vector<ExactPolygon> visible;  ///< convex, each with an area, not overlapping; wound like the facet
  ExactPolygon before = facet;        ///< what of it lies before the receiver; empty if that has no area
};

/// What a point sees of a light.
struct VisiblePart {
  /// A part of a segment, as shares of the way from its start to its end.
  using Interval = std::array<Rational, 2>;

  Region region = Region::lit;
  std::vector<VisibleFacet>
      facets;  ///< of an area light: one, or the triangles of a rounded polygon; none if a bare point is unlit
  std::vector<Interval> intervals;  ///< of a linear light: disjoint, each with a length, ascending
  bool any_before = true;           ///< whether anything of the light lies before the receiver
  std::optional<Interval> before = Interval{Rational(0), Rational(1)};  ///< of a linear light: what lies there
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

/// The same of what lies before a receiver at p: of a light only that is received.
///
/// Definition: unlit also where nothing of the light that has an area (length) lies before the plane; else lit if all
/// of
///             that is visible, umbra if none of it. Of a rounded polygon only the triangles that show p their face
///             count, unless none does.
VisiblePart visible_part(const Light& light, std::span<const std::vector<HidingCondition>> hidden, const ExactVector& p,
                         const ExactPlane& receiver);

/// The triangles of the fan from the first vertex that have an area, or the polygon's corners where it is flat.
std::vector<ExactPolygon> flat_facets(const ConvexPolygon& polygon);

/// The visible part of which exact_visibility tells the region and the fraction.
VisiblePart exact_visible_part(const Light& light, const Obstacles& obstacles, const Point3& p);
VisiblePart exact_visible_part(const Light& light, const Obstacles& obstacles, const ReceiverPoint& receiver);

}  // namespace gnomon
