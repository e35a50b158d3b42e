#pragma once

/// Exact rational vectors and planes for deciding laws by definition.

#include <optional>
#include <span>
#include <vector>

#include "geometry/numbers/kernel.h"

namespace gnomon::laws {

/// A point or vector of space with exact coordinates.
struct ExactVector {
  Rational x = 0;
  Rational y = 0;
  Rational z = 0;

  friend bool operator==(const ExactVector&, const ExactVector&) = default;
};

ExactVector exact(const Point3& p);
std::vector<ExactVector> exact(std::span<const Point3> points);

ExactVector operator+(const ExactVector& a, const ExactVector& b);
ExactVector operator-(const ExactVector& a, const ExactVector& b);
ExactVector operator*(const Rational& s, const ExactVector& a);
Rational dot(const ExactVector& a, const ExactVector& b);
ExactVector cross(const ExactVector& a, const ExactVector& b);
bool is_zero(const ExactVector& a);

/// -1, 0 or +1.
int sign(const Rational& r);

/// A plane with a positive side; a zero normal stands for no plane, and every height above it is 0.
struct ExactPlane {
  ExactVector normal;
  Rational offset = 0;

  /// Zero on the plane, of the sign of the side elsewhere; linear.
  Rational height(const ExactVector& p) const;

  int side(const ExactVector& p) const { return sign(height(p)); }

  ExactPlane reversed() const;
};

/// The plane through three points; a, b, c run counterclockwise seen from its positive side.
ExactPlane plane_through(const ExactVector& a, const ExactVector& b, const ExactVector& c);

/// The plane of a flat polygon; its vertices run counterclockwise seen from the positive side.
ExactPlane plane_of(std::span<const ExactVector> polygon);

/// The mean of the vertices: inside the polygon's relative interior.
ExactVector middle(std::span<const ExactVector> polygon);

/// -1 or +1 if all points lie on that closed side, not all of them on the plane; 0 if all lie on the plane; nothing if
/// they lie on both sides.
std::optional<int> common_side(const ExactPlane& plane, std::span<const ExactVector> points);

}  // namespace gnomon::laws
