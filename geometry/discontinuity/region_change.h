#pragma once

/// Whether what a face sees of the light may vanish somewhere in it. Private to this folder.

#include <array>
#include <span>

#include "geometry/discontinuity/event_scene.h"
#include "geometry/numbers/exact_vector.h"

namespace gnomon::event {

/// A triangle of a face whose corners lie on the face's boundary.
struct FacePiece {
  std::array<ExactVector, 3> corners;
  std::array<bool, 3> is_border{};  ///< whether the side from each corner to the next lies on the boundary
};

/// False only if all points inside of a face that no traced event crosses see some light, or all see none.
///
/// Definition: between points that see some light and points that see none the last visible part of the light shrinks
///             to a point q, as it is seen from a point p. A part with a vertex of the light or of a blocker on its
///             outline keeps it throughout the face, so this one is a convex polygon, all of whose edges come to run
///             through q. Three of them do so that what they leave open has no direction in common, each of the light
///             or of a different blocker, crossing pairwise as seen from p. Proved is that there is no such p. A
///             triangle is cleared of three edges if over all of it two of them do not cross; or one is no part of an
///             outline; or what they leave open has a direction in common; or the determinant of the normals of their
///             planes through p, a quadratic function of p, has Bernstein coefficients of one sign. Else it is halved
///             at its longest side.
/// Termination: at most `most_pieces` triangles, none of them halved more than `most_halvings` times; the answer is
///             true beyond that, and where more than `most_outlines` edges are near.
/// Exactness:  intervals, and rational arithmetic where these do not tell. Triangles are halved at rational points.
bool region_may_change(const EventScene& scene, std::span<const ShapeId> shapes, std::span<const FacePiece> face);

inline constexpr int most_halvings = 10;
inline constexpr int most_pieces = 400;
inline constexpr std::size_t most_outlines = 160;

}  // namespace gnomon::event
