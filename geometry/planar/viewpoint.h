#pragma once

#include <optional>

#include "geometry/planar/exact_polygon.h"
#include "geometry/point.h"

namespace gnomon::planar {

/// A point from which the light is looked at: an input point, or one constructed exactly.
struct Viewpoint {
  Point2 near;                      ///< the point, each coordinate rounded to nearest
  double error = 0;                 ///< bounds what rounding moved a coordinate by
  std::optional<ExactPoint> exact;  ///< nothing: `near` is the point

  explicit Viewpoint(const Point2& point) : near(point) {}
  explicit Viewpoint(ExactPoint point);

  ExactPoint exact_point() const;
};

/// The sign of orientation(p, q, r), exactly.
int orientation(const Viewpoint& p, const Point2& q, const Point2& r);

/// The sign of (b - a) x (p - q): on which side of the parallel to the line a b through q the viewpoint lies.
int height_order(const Point2& a, const Point2& b, const Point2& q, const Viewpoint& p);

}  // namespace gnomon::planar
