#pragma once

/// Cylindrical coordinates about a linear light. Private to geometry/visibility.

#include <array>
#include <cstdint>
#include <span>

#include "geometry/visibility/viewpoint_rays.h"
#include "gnomon/light.h"

namespace gnomon::viewpoint {

/// A point about a light: how far round, how far from the light's line, how far along it from the light's start.
///
/// The turn is no angle but grows with it: 4 in a whole turn, 2 in half a one, from -2 to 2. It needs no arc tangent.
struct CylinderPlace {
  double turn = 0;
  double distance = 0;
  double along = 0;
  double turn_error = 0;  ///< |turn - exact|, modulo 4, is at most this; infinite for a point too near the line to tell
  double error = 0;       ///< the same of `distance` and of `along`
};

/// A box of cylindrical coordinates that holds a convex set, whatever was rounded.
struct CylinderBox {
  double low_turn = 0, high_turn = 0;  ///< by less than 2, or from -3 to 3
  double low_distance = 0, high_distance = 0;
  double low_along = 0, high_along = 0;

  bool is_all_round() const { return high_turn - low_turn > 2; }
};

/// Two points of a list.
using PointPair = std::array<std::uint32_t, 2>;

class LightCylinder {
 public:
  /// The widest turn_error that is finite.
  static constexpr double widest_turn_error = 0x1p-8;

  /// Requires: coordinates of at most `largest`, as of all points below; two different ends.
  explicit LightCylinder(const LinearLight& light);

  /// Bound. The frame's vectors are off by at most 32 u, the step from the start by u of its size; products and sums
  /// bring 3 u more: 70 u |step| for each coordinate, and 100 u |step| for the distance; `error` is 2^-44 |step|. The
  /// turn's slope is at most 1, so it is off by less than twice error / distance, and by what its own rounding brings.
  CylinderPlace place_of(const Point3& p) const;

  /// The box of the hull of points; `edges` hold at least the edges of the hull.
  ///
  /// Definition: the set's turns are those of its points if these lie within less than half a turn, for then a sector
  ///             holds them; else the light's line may pierce it, and it is taken to lie all round. The distance is at
  ///             least the least height of the points along any direction across the light: that of the nearest point
  ///             of an edge is the best.
  CylinderBox box_of(std::span<const Point3> points, std::span<const PointPair> edges) const;

  double length() const { return length_; }  ///< of the light
  double length_error() const { return 0x1p-44 * length_; }

 private:
  /// Across the light.
  struct Across {
    double x = 0;
    double y = 0;
  };
  Across across(const Point3& p) const;
  Across nearest(std::span<const Point3> points, std::span<const PointPair> edges) const;

  Point3 start_;
  Vector along_, first_, second_;  ///< an orthonormal frame, right-handed
  double length_ = 0;
};

}  // namespace gnomon::viewpoint
