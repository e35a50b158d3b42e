#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "geometry/planar/exact_polygon.h"
#include "gnomon/point.h"

namespace gnomon::planar {

/// A point from which the light is looked at: an input point, or one constructed exactly.
class Viewpoint {
 public:
  explicit Viewpoint(const Point2& point) : near_(point) {}
  explicit Viewpoint(ExactPoint point);

  /// A constructed point whose coordinates are known up to `error`, and exactly when `exact` is asked.
  Viewpoint(const Point2& near, double error, std::function<ExactPoint()> exact)
      : near_(near), error_(error), evaluate_(std::move(exact)) {}

  const Point2& near() const { return near_; }

  /// Bounds the distance of each coordinate from that of near().
  double error() const { return error_; }

  /// True if near() is the point itself.
  bool is_input() const { return !evaluate_; }

  ExactPoint exact() const;

 private:
  Point2 near_;
  double error_ = 0;
  std::function<ExactPoint()> evaluate_;
  mutable std::optional<ExactPoint> exact_;
};

/// The sign of orientation(p, q, r), exactly.
int orientation(const Viewpoint& p, const Point2& q, const Point2& r);

/// The sign of (b - a) x (p - q): on which side of the parallel to the line a b through q the viewpoint lies.
int height_order(const Point2& a, const Point2& b, const Point2& q, const Viewpoint& p);

}  // namespace gnomon::planar
