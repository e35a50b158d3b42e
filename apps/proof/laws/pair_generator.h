#pragma once

#include <vector>

#include "apps/proof/laws/spatial_cases.h"

namespace gnomon::laws {

/// A light and a blocker.
struct Pair {
  Light light;
  ConvexPolygon blocker;
};

/// The light's vertices as they stand in the scene.
std::vector<Point3> light_points(const Light& light);

/// a + s * b, rounded like any double.
inline Point3 moved(const Point3& a, double s, const Point3& b) {
  return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

/// a + t (b - a)
inline Point3 between(const Point3& a, double t, const Point3& b) {
  return moved(a, t, moved(b, -1, a));
}

/// Draws the vertices of an exactly flat convex polygon with small coordinates in a random plane, collinear ones among
/// them; a needle is stretched along a direction of the plane.
///
/// Requires: called inside rc::gen::exec; a power of two.
std::vector<Point3> draw_flat_points(double stretch);

/// Draws a pair in standard position.
///
/// Requires: called inside rc::gen::exec.
Pair draw_pair(Domain domain, Lights lights);

/// The point with one coordinate moved to a neighbouring double, which one is drawn; a zero moves by 2^-53 or by the
/// smallest double.
Point3 nudged(const Point3& p);

/// The same, but not by less than what matters beside whole numbers.
Point3 nudged_beside_whole_numbers(const Point3& p);

}  // namespace gnomon::laws
