#pragma once

/// Points, directions and planes in whole numbers that have no common divisor: equal ones have equal numbers, and
/// numbers do not grow with the way on which a point was found.

#include <optional>
#include <span>

#include "geometry/numbers/exact_vector.h"
#include "gnomon/shadow_volume.h"

namespace gnomon::inverse {

/// A point (x, y, z, w) with w > 0, a direction (x, y, z, 0), or a plane (n, d), whose half-space is n x + d w <= 0.
using Whole = Quadruple<Integer>;

/// The numbers without their greatest common divisor; signs stay.
Whole reduced(Whole numbers);

Whole whole_point(const ExactVector& p);
Whole whole_point(const Point3& p);
Whole whole_direction(const ExactVector& v);
Whole whole_direction(const Point3& v);

/// The half-space n x + d <= 0.
Whole whole_plane(const ExactVector& normal, const Rational& offset);

/// Orientation: the half-space is the same.
Whole whole_plane(const HalfSpace& half_space);

/// The value of a plane at a point or direction.
Integer value(const Whole& plane, const Whole& point);

ExactVector normal_of(const Whole& plane);

/// Requires: a point.
ExactVector coordinates(const Whole& point);

/// The vector that three others leave free, up to sign; zero if they are dependent. Of three points' it is the plane
/// through them.
Whole complement(const Whole& a, const Whole& b, const Whole& c);

/// The same with its length as determinants have it.
Whole unreduced_complement(const Whole& a, const Whole& b, const Whole& c);

/// The half-spaces, up to positive factors, whose intersection is the convex hull of the points and directions, closed.
///
/// Returns: each half-space with a facet once; nothing if all lie in one plane.
std::optional<std::vector<Whole>> hull_half_spaces(std::span<const Whole> generators);

}  // namespace gnomon::inverse
