#pragma once

#include <vector>

#include "gnomon/blocker.h"
#include "gnomon/light.h"

namespace gnomon::report {

/// A one-sided square light of half a side `half` at height z, shining down.
AreaLight square_light(double half, double z);

/// A rectangle at height z.
ConvexBlocker board(double x_min, double x_max, double y_min, double y_max, double z);

/// A square on its tip at height z, its corners at a distance from (0, 0, z).
ConvexBlocker diamond(double distance, double z);

/// A rectangle in the plane of constant x.
ConvexBlocker blade(double x, double y_min, double y_max, double z_min, double z_max);

/// A polygon of many corners on an ellipse, in a plane that doubles hold: exactly flat. `turned` shines down.
std::vector<Point3> flat_round(int corners, double radius, double z);

/// The corners of a cube of side 2 about a centre, turned by an angle about an axis that is not aligned, rounded.
std::vector<Point3> turned_cube(const Point3& centre, double angle);

/// The shape with every coordinate multiplied by a factor (a power of two, to be exact) and moved.
ConvexPolygon mapped(const ConvexPolygon& polygon, double factor, const Point3& offset);
AreaLight mapped(const AreaLight& light, double factor, const Point3& offset);
ConvexBlocker mapped(const ConvexBlocker& blocker, double factor, const Point3& offset);

}  // namespace gnomon::report
