#pragma once

/// The definitions of the theory in the plane, decided as they are written. Vectors have z = 0.

#include <array>
#include <span>
#include <vector>

#include "apps/proof/laws/exact.h"

namespace gnomon::laws {

ExactVector exact(const Point2& p);

/// Where p lies as seen from a toward b: +1 left, 0 on the line, -1 right.
int side_of(const ExactVector& a, const ExactVector& b, const ExactVector& p);

/// The share of a point or linear light that a segment leaves visible from p, by length; counting for a point light.
///
/// Definition: p is blocked from a point l of the light if the open segment (p, l) meets the closed blocker.
/// Requires:   one light point, or two different ones; two different blocker points.
Rational visible_fraction(std::span<const Point2> light, const std::array<Point2, 2>& blocker, const ExactVector& p);

/// The same for any number of segments.
Rational visible_fraction(std::span<const Point2> light, std::span<const std::array<Point2, 2>> blockers,
                          const ExactVector& p);

/// A part of a linear light, by places along it from 0 to 1.
struct LightPart {
  Rational from;
  Rational to;
};

/// The parts of a linear light that any number of segments leave visible from p, maximal, in order, up to single
/// points.
std::vector<LightPart> visible_parts(std::span<const Point2> light, std::span<const std::array<Point2, 2>> blockers,
                                     const ExactVector& p);

}  // namespace gnomon::laws
