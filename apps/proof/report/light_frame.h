#pragma once

#include <vector>

#include "gnomon/convex_polygon.h"
#include "gnomon/point.h"

namespace gnomon::report {

/// A polygon's plane with rectangular coordinates, in plain doubles.
class LightFrame {
 public:
  explicit LightFrame(const ConvexPolygon& polygon);

  /// Height of a point above the plane, on the polygon's front.
  double height(const Point3& p) const;

  /// Coordinates of the foot of a point in the plane.
  Point2 flat(const Point3& p) const;

  /// The point of the plane with these coordinates.
  Point3 lifted(const Point2& q) const;

 private:
  Point3 origin_;
  Point3 u_;
  Point3 v_;
  Point3 normal_;
};

}  // namespace gnomon::report
