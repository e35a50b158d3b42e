#pragma once

#include <vector>

#include "geometry/numbers/kernel.h"
#include "geometry/numbers/vector3.h"
#include "gnomon/point.h"

namespace gnomon {

/// A point or vector of space with rational coordinates.
using ExactVector = Vector3<Rational>;

/// A convex polygon with rational vertices.
using ExactPolygon = std::vector<ExactVector>;

inline ExactVector exact(const Point3& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

/// Whole numbers (x, y, z, w) in the proportion of (x, y, z, 1), w positive.
Quadruple<Integer> whole_coordinates(const ExactVector& p);

/// A plane, as the linear function that is zero on it.
struct ExactPlane {
  ExactVector normal;
  Rational offset = 0;

  /// Zero on the plane, positive on the side to which the normal points.
  Rational height(const ExactVector& p) const;
  /// The slope along a direction: the sign of the height far out on a ray.
  Rational slope(const ExactVector& direction) const { return dot(normal, direction); }
};

/// The plane through three points; they run counterclockwise seen from its positive side.
ExactPlane plane_through(const ExactVector& a, const ExactVector& b, const ExactVector& c);

/// Twice the area of a planar polygon, as the vector along its normal, counterclockwise seen from its tip.
ExactVector doubled_area(const ExactPolygon& polygon);

}  // namespace gnomon
