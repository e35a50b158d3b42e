#pragma once

/// The definitions of the theory, decided as they are written, in exact arithmetic and without regard to speed.

#include <optional>

#include "apps/proof/laws/exact.h"
#include "gnomon/light.h"

namespace gnomon::laws {

/// The light's vertices: one, two or those of the polygon.
///
/// Requires: the light is not directional.
/// Throws:   PreconditionError.
std::vector<ExactVector> vertices(const Light& light);

/// True if the light lies strictly on one side of the blocker's plane, and the blocker strictly in front of an area
/// light (on either side of a two-sided one).
bool stands_apart(const Light& light, const ConvexPolygon& blocker);

/// The share of the light that the blocker leaves visible from p, by length or area; counting for a point light.
/// Nothing if the light shows p its back or its edge.
///
/// Definition: p is blocked from a point l of the light if the open segment (p, l) meets the blocker.
/// Requires:   a flat blocker; not both p and a linear or point light in its plane; the light is not directional.
/// Throws:     PreconditionError.
std::optional<Rational> visible_fraction(const Light& light, const ConvexPolygon& blocker, const ExactVector& p);

/// True if the closed segment [p, l] meets the blocker: p lies in the vertex shadow of l.
///
/// Requires: a flat blocker; p and l not both in its plane.
/// Throws:   PreconditionError.
bool segment_meets(const ExactVector& p, const ExactVector& l, const ConvexPolygon& blocker);

/// True if p is a point of the blocker.
///
/// Requires: a flat blocker.
bool lies_on(const ExactVector& p, const ConvexPolygon& blocker);

}  // namespace gnomon::laws
