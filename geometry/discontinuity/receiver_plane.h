#pragma once

/// A receiver's plane and two of the three coordinates on it. Private to this folder.

#include <array>

#include "geometry/discontinuity/event_point.h"
#include "geometry/discontinuity/receiver_arrangement.h"
#include "geometry/numbers/exact_vector.h"

namespace gnomon::event {

/// A point of space, somewhere in a box.
using PointEnclosure = Vector3<Interval>;

/// The plane of a flat polygon.
///
/// Orientation: the normal points to the front; what runs counterclockwise in flat coordinates does so seen from the
///              front.
class ReceiverPlane {
 public:
  ReceiverPlane(const Point3& p, const Point3& q, const Point3& r);

  const ExactPlane& plane() const { return plane_; }

  FlatPoint flat(const ExactVector& point) const;
  FlatPoint flat(const Quadruple<ExactReal>& point) const;
  /// The point of the plane with these flat coordinates.
  ExactVector spatial(const FlatPoint& point) const;

  /// The same of a point in a box. Requires: the rounding mode is protected.
  PointEnclosure spatial(const FlatEnclosure& point) const;

  /// Whether a point somewhere in a box certainly lies off the plane. Requires: the rounding mode is protected.
  bool is_certainly_off(const PointEnclosure& point) const;

  /// The square of a polygon's area divided by that of its flat image.
  Rational squared_stretch() const;

 private:
  ExactPlane plane_;
  std::size_t u_ = 0;
  std::size_t v_ = 1;
  std::size_t dropped_ = 2;
  std::array<Interval, 4> near_{Interval(0), Interval(0), Interval(0), Interval(0)};  ///< normal and offset
};

/// Coordinates by number.
const Rational& coordinate(const ExactVector& v, std::size_t axis);

/// The point with homogeneous coordinates; w is not 0.
ExactVector affine(const Quadruple<ExactReal>& point);

/// Where a point of the scene, or one constructed from it, lies.
ExactVector exact_place(const EventPoint& point);

/// A constructed point with whole numbers for coordinates.
EventPoint constructed_point(const ExactVector& place);

/// The part of a segment in a convex polygon that runs counterclockwise; false if it has no length.
bool clip(FlatSegment& segment, std::span<const FlatPoint> polygon);

}  // namespace gnomon::event
