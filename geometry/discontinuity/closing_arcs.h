#pragma once

/// Where three edges in line may close the last gap of light in a face. Private to this folder.

#include <array>
#include <span>
#include <vector>

#include "geometry/conics/curve_map.h"
#include "geometry/discontinuity/event_scene.h"
#include "geometry/discontinuity/receiver_plane.h"

namespace gnomon::event {

/// A triangle of a face whose corners lie on the face's boundary.
using FacePiece = std::array<ExactVector, 3>;

/// Arcs, each the trace of the lines that meet three edges.
struct ClosingArcs {
  std::vector<conic::NamedArc> arcs;
  std::vector<std::array<EventElement, 3>> names;  ///< the edges of each: of the light first, then as they are numbered
};

/// All arcs in pieces of a face, which no traced event crosses, on which its points may begin or cease to see some
/// light.
///
/// Definition: between points that see some light and points that see none the last visible part of the light shrinks
///             to a point q, as it is seen from a point p. A part with a vertex of the light or of a blocker on its
///             outline keeps it throughout the face, so this one is a convex polygon, all of whose edges come to run
///             through q. Three of them do so that what they leave open has no direction in common, each of the light
///             or of a different blocker, crossing pairwise as seen from p: p lies on the trace of the lines that meet
///             these three. Under a linear light the part is a segment, and two edges of blockers close it.
/// Left out:   what closing_triples.h and open_lines.h know to close no gap, and what lies beyond one side of each
///             triangle of the face. More arcs than there are events do no harm: what is told apart by none is one
///             region.
/// Coplanar:   where two of the edges lie in one plane, the lines in that plane are traced by wedges; those through the
///             point where the two meet inside of both are given here, as straight traces.
/// Exactness:  intervals, and exact arithmetic where these do not tell.
ClosingArcs closing_arcs(const EventScene& scene, std::span<const ShapeId> shapes, std::span<const FacePiece> pieces,
                         const ReceiverPlane& plane);

}  // namespace gnomon::event
