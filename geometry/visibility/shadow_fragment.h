#pragma once

/// Convex polygons with exact corners, cut by planes. Private to this folder.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/numbers/exact_vector.h"
#include "geometry/visibility/viewpoint_rays.h"

namespace gnomon::viewpoint {

/// An oriented plane that doubles judge where they can: given by three points, or by two points and a direction.
class SignedPlane {
 public:
  /// Positive where the points run counterclockwise.
  static SignedPlane through(const Point3& a, const Point3& b, const Point3& c);
  /// The plane through both points that holds the direction; positive is the side of exact_direction_side(a, b, p, d).
  static SignedPlane along(const Point3& a, const Point3& b, const Point3& direction);

  SignedPlane reversed() const;

  /// -1, 0, +1; exact.
  int side(const Point3& p) const {
    const Vector step = p - points_[0];
    const double value = dot(normal_, step);
    const double bound = side_bound_ * size_of(step) + tiny;
    return value > bound ? 1 : value < -bound ? -1 : exact_side(p);
  }
  /// The same of an exact point, given the doubles nearest to it.
  int side(const Point3& near, const ExactVector& p) const;

  ExactPlane exact_plane() const;

 private:
  SignedPlane(const std::array<Point3, 3>& points, bool is_along);
  int exact_side(const Point3& p) const;

  std::array<Point3, 3> points_;
  bool is_along_ = false;  ///< the third is a direction
  bool is_reversed_ = false;
  Vector normal_;
  double size_ = 0;        ///< of the normal, at least
  double side_bound_ = 0;  ///< times the size of a step from the first point: at least the error of their product
};

/// A corner, and what bounds the polygon on the way to the next one.
struct FragmentCorner {
  ExactVector point;
  Point3 near;            ///< nearest doubles
  std::int32_t edge = 0;  ///< of the polygon that it was; -1 along a plane that cut it
};

/// A part of a convex polygon.
using Fragment = std::vector<FragmentCorner>;

/// The whole of a polygon.
Fragment fragment_of(std::span<const Point3> corners);

/// The parts of a fragment on both sides of a plane; empty without an area there. Edges in the plane are told as cut.
struct SplitFragment {
  Fragment positive;
  Fragment negative;
};
SplitFragment split(const Fragment& fragment, const SignedPlane& plane);

}  // namespace gnomon::viewpoint
