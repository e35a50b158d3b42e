#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gnomon/convex_polygon.h"
#include "gnomon/point.h"

namespace gnomon {

/// Points spread over a receiver in rows.
///
/// Definition:  u runs along the polygon's first side, v at right angles to it towards the polygon's inside. The grid
///              divides the smallest rectangle along u and v that holds the polygon into equal cells, and has a point
///              in the middle of each; u runs fastest.
/// Orientation: u, v and the normal, which points to the front, are right-handed.
/// Exactness:   points and normal are rounded, by a few units in the last place.
class ReceiverGrid {
 public:
  /// `shape` tells the number of points along u and v.
  /// Requires: both are positive.
  ReceiverGrid(const ConvexPolygon& receiver, const std::array<std::uint32_t, 2>& shape);

  std::size_t size() const { return std::size_t{shape_[0]} * shape_[1]; }

  /// The point of that index, as doubles.
  Point3 point(std::size_t index) const;

  /// False where the rectangle is so wide that places in it overflow.
  bool has_finite_points() const;

  /// Of unit length.
  Point3 normal() const { return normal_; }

  /// True if the point lies on the receiver, its boundary included, seen along the axis nearest to the normal.
  /// Exactness: exact for the point in doubles.
  bool is_on_receiver(const Point3& point) const;

 private:
  std::vector<Point3> corners_;
  std::array<std::uint32_t, 2> shape_;
  Point3 origin_;
  Point3 u_;  ///< along a whole side of the rectangle
  Point3 v_;
  Point3 normal_;
};

/// The mean of a polygon's corners, rounded.
Point3 mean_of_corners(const ConvexPolygon& polygon);

/// The point moved by a length along a normal, rounded.
/// Requires: the normal is not zero.
Point3 moved_along(const Point3& p, const Point3& normal, double length);

}  // namespace gnomon
