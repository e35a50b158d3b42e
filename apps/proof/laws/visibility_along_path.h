#pragma once

/// What is seen from the points of a straight path just after it starts: the visible share of the light as a power
/// series, and which edges bound what is seen.

#include <array>
#include <optional>
#include <vector>

#include "apps/proof/laws/germ.h"
#include "apps/proof/laws/visibility_definition.h"

namespace gnomon::laws {

/// The points start + t * direction, for small positive t. With a front, which is a normal of a receiver, their limits
/// from there are meant: start + t * direction + e * front, where e is much smaller than t.
struct Path {
  ExactVector start;
  ExactVector direction;
  std::optional<ExactVector> front = {};

  Path reversed() const { return {start, Rational(-1) * direction, front}; }
};

/// The visible share of the light, as a power series at t = 0.
///
/// Definition: a point of the light is hidden if the open segment to it meets a blocker. The hidden part of one blocker
///             is the intersection of half-planes of the light's plane (Fourier and Motzkin's elimination of the place
///             on the segment from the inequalities of all walls); every half-plane's coefficients are linear in t, and
///             corners are products of two of them. So the order of all corners along and beside all lines is the sign
///             of a polynomial in t of degree 3, which is decided for all small t at once; then the share is one
///             rational function on an interval (0, t1), and its power series is that of its corners' quotients.
/// Requires:   a linear or flat area light; start + t * direction is strictly in front of it for small t (from either
///             side of a two-sided one) or else unlit: 0.
/// Exactness:  exact, for every position. Cost: exponential in the number of blockers.
Jet visible_share_after(const Light& light, const std::vector<Walls>& blockers, const Path& path);

/// The same of a light with these vertices, of which two are ends of a segment.
/// Requires: start + t * direction is strictly in front of it.
Jet visible_share_after(const std::vector<ExactVector>& light, const std::vector<Walls>& blockers, const Path& path);

/// The order of the discontinuity of the visible share where a path runs through its start: 0, 1 or 2 if value, slope
/// or second derivative of before and after differ; nothing if they are the same.
///
/// Definition: with a0 + a1 t + a2 t² after the start and b0 + b1 s + b2 s² before it, s being the way back, they agree
///             if a0 = b0, a1 = -b1 and a2 = b2.
std::optional<int> order_at_start(const std::vector<ExactVector>& light, const std::vector<Walls>& blockers,
                                  const Path& path);

/// True if nothing is hidden just after the start.
/// Requires: as visible_share_after, and in front of the light.
bool is_lit_after(const Light& light, const std::vector<Walls>& blockers, const Path& path);

/// An edge as it is seen: of the light (`of` is -1) or a blocker, by two of its walls; those of a polygon have the same
/// wall twice.
struct VisibleEdge {
  int of = -1;
  int first = 0;
  int second = 0;

  friend auto operator<=>(const VisibleEdge&, const VisibleEdge&) = default;  // NOLINT(modernize-use-nullptr)
};

/// A piece of an edge between what is seen of the light and what is not, and the edges it ends at.
struct VisiblePiece {
  VisibleEdge edge;
  VisibleEdge from;
  VisibleEdge to;

  friend auto operator<=>(const VisiblePiece&, const VisiblePiece&) = default;  // NOLINT(modernize-use-nullptr)
};

/// All pieces of the boundary of what is seen of an area light from the path's start, in a fixed order. Which pieces
/// meet is told by their ends, so two points that have this in common see one arrangement of edges. Nothing where
/// unlit.
std::vector<VisiblePiece> visible_pieces(const AreaLight& light, const std::vector<Walls>& blockers, const Path& path);

}  // namespace gnomon::laws
